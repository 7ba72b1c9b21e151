// A firefly is a texel far brighter than those beside it, by a fault of the host's or a light smaller than a pixel: blurred, it
// would be a spot. A texel keeps its light up to 16 times that of the brightest of those beside it; from there on it loses
// light, and from 256 times on has as much as that one. One without light has as much as the
// darkest, and one far below none, too.
#ifndef FIREFLY_GLSL
#define FIREFLY_GLSL

const float unharmed = 16.0;

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
    float bright = brightness(color);
    float bound = max(brightness(least), brightness(most));
    if (bright <= 0.0) return least;
    float kept = max(1.0, unharmed * unharmed * bound / bright);
    return bright > unharmed * bound ? clamp(color * (kept * bound / bright), least, most * kept) : color;
}

// Bits of floats order as the floats do where none is negative. CPU devices compare integers in one step, floats in three.
uint brightnessBits(vec3 color) {
    uvec3 sizes = floatBitsToUint(color) & 0x7fffffffu;
    return max(sizes.r, max(sizes.g, sizes.b));
}

struct Outlier {
    vec3 color;
    vec3 least;   // of the others
    vec3 most;
};

Outlier oneOf(Four all, bool isUpper, bool isLeft) {
    bvec3 upper = bvec3(isUpper);
    vec3 left = mix(all.lowerLeft, all.upperLeft, upper);
    vec3 right = mix(all.lowerRight, all.upperRight, upper);
    vec3 otherLeft = mix(all.upperLeft, all.lowerLeft, upper);
    vec3 otherRight = mix(all.upperRight, all.lowerRight, upper);
    vec3 beside = mix(left, right, bvec3(isLeft));
    return Outlier(mix(right, left, bvec3(isLeft)), min(beside, min(otherLeft, otherRight)),
                   max(beside, max(otherLeft, otherRight)));
}

// A color, or what stands for it where it is darker than the first bound or brighter than the second.
vec3 tamed(vec3 color, uint bright, uvec2 bounds, vec3 darkest, vec3 dimmed) {
    return mix(mix(color, darkest, bvec3(bright < bounds.x)), dimmed, bvec3(bright > bounds.y));
}

// besides() of each. At most one is a firefly; and of two without light none gains any.
Four withoutFireflies(Four all) {
    uvec4 bright = uvec4(brightnessBits(all.upperLeft), brightnessBits(all.upperRight), brightnessBits(all.lowerLeft),
                         brightnessBits(all.lowerRight));
    uvec2 darker = min(bright.xz, bright.yw);
    uvec2 brighter = max(bright.xz, bright.yw);
    float most = max(uintBitsToFloat(max(brighter.x, brighter.y)), 1e-30);
    float bound = uintBitsToFloat(max(min(brighter.x, brighter.y), max(darker.x, darker.y)));
    float kept = max(1.0, unharmed * unharmed * bound / most);
    bool isUpper = brighter.x > brighter.y;
    Outlier firefly = oneOf(all, isUpper, isUpper ? bright.x > bright.y : bright.z > bright.w);
    vec3 dimmed = min(max(firefly.color * (kept * bound / most), firefly.least), firefly.most * kept);
    isUpper = darker.x < darker.y;
    vec3 darkest = oneOf(all, isUpper, isUpper ? bright.x < bright.y : bright.z < bright.w).least;
    bool isAlone = min(max(darker.x, darker.y), min(brighter.x, brighter.y)) > 0u;
    uvec2 bounds = uvec2(isAlone ? 1u : 0u, floatBitsToUint(unharmed * bound));
    return Four(tamed(all.upperLeft, bright.x, bounds, darkest, dimmed), tamed(all.upperRight, bright.y, bounds, darkest, dimmed),
                tamed(all.lowerLeft, bright.z, bounds, darkest, dimmed), tamed(all.lowerRight, bright.w, bounds, darkest, dimmed));
}

#endif
