// Foam on the surface: its cover from the waves' history, broken up by a pattern, and its light.

const float foamTile = 24.0;   // [m], as in water/surface.h

// Share of the surface that is white: what each cascade's breakers left (water/foam_history.h).
float foamCover() {
    float clear = 1.0;
    for (int i = 0; i < foamCascades; ++i) {
        vec2 steps = texture(foamHistory, vec3(cascade[i].xy + calmPosition * cascade[i].z, i)).rg;
        clear *= 1.0 - mix(steps.x, steps.y, foam.x);
    }
    return 1.0 - clear;
}

// How much of an octave of the pattern a pixel still shows; the rest is its mean.
float octaveShown(float tile, float pixelWidth) {
    const float patternSamples = 256.0;
    return 1.0 - clamp(0.5 * log2(max(pixelWidth * patternSamples / tile, 1.0)), 0.0, 1.0);
}

// Cover breaks up into rafts and lace where they can be seen, and is a mean where they cannot: white is a share `cover`
// of the surface either way.
float foamMask(float cover) {
    const vec3 weights = vec3(0.35, 0.4, 0.25);
    const vec3 tiles = foamTile / vec3(1.0, 5.0, 17.0);
    vec2 stepSize = max(abs(dFdx(calmPosition)), abs(dFdy(calmPosition)));
    float pixelWidth = max(stepSize.x, stepSize.y);
    float pattern = 0.0;
    float variance = 1e-5;
    for (int i = 0; i < 3; ++i) {
        float weight = weights[i] * octaveShown(tiles[i], pixelWidth);
        pattern += weight * (texture(foamPattern, (foam.zw + calmPosition) / tiles[i]).r - 0.5);
        variance += weight * weight / 12.0;   // of an even distribution
    }
    // The octaves' sum is nearly normal; as its own distribution function it is even again, so that a share `cover` of
    // it lies below `cover`.
    float even = 1.0 / (1.0 + exp(-1.702 * pattern * inversesqrt(variance)));
    float edge = min(0.12, 0.5 * min(cover, 1.0 - cover)) + 1e-4;
    float rafts = smoothstep(-edge, edge, cover - even);
    return mix(cover, rafts, clamp(variance / 0.008, 0.0, 1.0));
}

vec3 withFoam(vec3 water, float mask, vec3 normal) {
    vec3 light = sunIrradiance.rgb * max(dot(normal, toSun.xyz), 0.0) + skyIrradiance.rgb;
    return mix(water, light * foam.y / pi, mask);
}
