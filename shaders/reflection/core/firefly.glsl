// A firefly is a texel far brighter than those beside it, by a fault of the host's or a light smaller than a pixel: blurred, it
// would be a spot. A texel keeps its light up to 16 times that of the brightest of those beside it; from there on it loses
// light, and from 256 times on has as much as that one. One without light has as much as the
// darkest, and one far below none, too.
#ifndef FIREFLY_GLSL
#define FIREFLY_GLSL

struct Four {
    vec3 upperLeft;
    vec3 upperRight;
    vec3 lowerLeft;
    vec3 lowerRight;
};

float brightness(vec3 color) {
    vec3 sizes = abs(color);
    return max(sizes.r, max(sizes.g, sizes.b));
}

// `least` and `most`: of those beside it, each channel.
vec3 besides(vec3 color, vec3 least, vec3 most) {
    const float unharmed = 16.0;
    float bright = brightness(color);
    float bound = max(brightness(least), brightness(most));
    if (bright <= 0.0) return least;
    float kept = max(1.0, unharmed * unharmed * bound / bright);
    return bright > unharmed * bound ? clamp(color * (kept * bound / bright), least, most * kept) : color;
}

Four withoutFireflies(Four all) {
    vec3 leastUp = min(all.upperLeft, all.upperRight);
    vec3 mostUp = max(all.upperLeft, all.upperRight);
    vec3 leastLow = min(all.lowerLeft, all.lowerRight);
    vec3 mostLow = max(all.lowerLeft, all.lowerRight);
    return Four(besides(all.upperLeft, min(all.upperRight, leastLow), max(all.upperRight, mostLow)),
                besides(all.upperRight, min(all.upperLeft, leastLow), max(all.upperLeft, mostLow)),
                besides(all.lowerLeft, min(all.lowerRight, leastUp), max(all.lowerRight, mostUp)),
                besides(all.lowerRight, min(all.lowerLeft, leastUp), max(all.lowerLeft, mostUp)));
}

#endif
