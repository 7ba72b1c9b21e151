// Takes sample 0 of each pixel of a multisampled image, or with RESOLVED the colour of what that sample shows:
// reflection/core/single_sample.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = samplesBinding) uniform sampler2DMS samples;   // with RESOLVED the depth's
#if defined(COLOR) || defined(RESOLVED)
layout(set = 0, binding = chosenBinding, rgba16f) uniform writeonly image2D chosen;
#else
layout(set = 0, binding = chosenBinding, r32f) uniform writeonly image2D chosen;
#endif

#ifdef RESOLVED
layout(set = 0, binding = resolvedBinding) uniform sampler2D resolved;

// Inverse distance, to a factor.
float nearnessAt(const MirrorBlock mirror, ivec2 pixel, int index) {
    return abs(texelFetch(samples, mirror.region.xy + pixel, index).r - mirror.infinityDepth);
}

// How many of a pixel's samples lie about as far away: on one surface.
int samplesBeside(const MirrorBlock mirror, ivec2 pixel, float nearness) {
    const float beside = 0.1;   // of the distance
    int all = textureSamples(samples);
    int count = 0;
    int i = 0;
    do {
        float there = nearnessAt(mirror, pixel, i);
        if (abs(there - nearness) <= beside * max(there, nearness)) ++count;
    } while (++i < all);
    return count;
}

// Along edges a pixel's colour is of both sides: of those around, that which has the most of the side of its sample 0.
ivec2 leastMixed(const MirrorBlock mirror, ivec2 pixel) {
    const ivec2 around[8] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1));
    float nearness = nearnessAt(mirror, pixel, 0);
    ivec2 best = pixel;
    int most = samplesBeside(mirror, pixel, nearness);
    if (most == textureSamples(samples)) return pixel;
    int i = 0;
    do {
        ivec2 beside = clamp(pixel + around[i], ivec2(0), mirror.region.zw - 1);
        int count = samplesBeside(mirror, beside, nearness);
        if (count > most) best = beside;
        most = max(most, count);
    } while (++i < 8);
    return best;
}
#endif

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, mirror.region.zw))) return;
#ifdef RESOLVED
    vec4 value = texelFetch(resolved, mirror.region.xy + leastMixed(mirror, pixel), 0);
#else
    vec4 value = texelFetch(samples, mirror.region.xy + pixel, 0);
#endif
    imageStore(chosen, mirror.region.xy + pixel, value);
}
