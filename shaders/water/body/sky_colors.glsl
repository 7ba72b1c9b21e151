// The sky of a host without a cube: LightingDesc::skyZenith.
#ifndef SKY_COLORS_GLSL
#define SKY_COLORS_GLSL

#include "body.glsl"

// Means of max(y, 0) and of its square where y has a Gaussian's variance: a square root for the error function, within 2 % of
// the deviation.
vec2 meansAbove(float y, float variance) {
    float root = sqrt(y * y + 0.64 * variance);
    float mean = 0.5 * (y + root);
    return vec2(mean, mean * mean + 0.68 * variance * mean / max(root, 1e-6));
}

// Share of the way from the horizon to the colour straight up, of what is seen around a direction that rises by `y`.
float shareAbove(float y, float variance) {
    vec2 means = meansAbove(y, variance);
    return clamp(2.0 * means.x - means.y, 0.0, 1.0);
}

// Seen along a direction of the world that strays by `spread` [rad].
vec3 skyOfColors(vec3 direction, float spread) {
    float strays = spread * spread;
    float y = normalize(direction).y;
    float variance = strays * (1.0 - y * y);
    y /= 1.0 + strays;   // the mean cosine to the middle
    vec3 radiance = water.skyHorizon.rgb + (water.skyZenith.rgb - water.skyHorizon.rgb) * shareAbove(y, variance);
    // Level water mirrors no ground, nor may the blur.
    if (tilted) radiance += (water.skyGround.rgb - water.skyHorizon.rgb) * shareAbove(-y, variance);
    return radiance;
}

#endif
