// How blurred a reflection is looked up. `tap` is, as ReflectionDesc says them: the clear distance [m], the scatter, and
// the distance at which the sky has taken over [m], 0 for nowhere. `distance` is from the mirror to what it shows [m].

// Width [m] of the bundle of rays that arrives there: a rough surface's cone of `cone` radians opens at the mirror, what
// is scattered does only beyond the clear distance.
float bundleWidth(float cone, float distance, vec3 tap) {
    return cone * distance + tap.y * max(distance - tap.x, 0.0);
}

// A texel of the pyramid, read linearly, spreads by 0.65 of its width [standard deviation]; a mean of 2 x 2 spreads by 0.5.
const float texelSpread = 1.29;

// How many texels' spreads the bundle is wide as the eye sees it, `toMirror` + `distance` metres away.
float bundleTexels(float width, float toMirror, float distance, float texelsPerRadian) {
    return width / (toMirror + distance) * texelsPerRadian / texelSpread;
}

// The mip whose texels are as wide.
float bundleMip(float texels) {
    return log2(max(texels, 1.0));
}

float shareOfScene(float distance, vec3 tap) {
    return tap.z > 0.0 ? 1.0 - smoothstep(0.5 * tap.z, tap.z, distance) : 1.0;
}
