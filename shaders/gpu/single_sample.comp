// Takes sample 0 of each pixel of a multisampled image, or with RESOLVED the colour of what that sample shows:
// gpu/view/single_sample.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "single_sample_block.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = singleSampleBinding, std140) uniform SingleSample {
    SingleSampleBlock stored;
};
layout(set = 0, binding = samplesBinding) uniform sampler2DMS samples;   // with RESOLVED the depth's
#if defined(COLOR) || defined(RESOLVED)
layout(set = 0, binding = chosenBinding, rgba16f) uniform writeonly image2D chosen;
#else
layout(set = 0, binding = chosenBinding, r32f) uniform writeonly image2D chosen;
#endif

#ifdef RESOLVED
layout(set = 0, binding = resolvedBinding) uniform sampler2D resolved;

// Inverse distance, to a factor.
float nearnessAt(const SingleSampleBlock view, ivec2 pixel, int index) {
    return abs(texelFetch(samples, view.region.xy + pixel, index).r - view.infinityDepth);
}

// How many of a pixel's samples lie about as far away: on one surface.
int samplesBeside(const SingleSampleBlock view, ivec2 pixel, float nearness) {
    const float beside = 0.1;   // of the distance
    int all = textureSamples(samples);
    int count = 0;
    int i = 0;
    do {
        float there = nearnessAt(view, pixel, i);
        if (abs(there - nearness) <= beside * max(there, nearness)) ++count;
    } while (++i < all);
    return count;
}

// Along edges a pixel's colour is of both sides: of those around, that which has the most of the side of its sample 0.
ivec2 leastMixed(const SingleSampleBlock view, ivec2 pixel) {
    const ivec2 around[8] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1));
    float nearness = nearnessAt(view, pixel, 0);
    ivec2 best = pixel;
    int most = samplesBeside(view, pixel, nearness);
    if (most == textureSamples(samples)) return pixel;
    int i = 0;
    do {
        ivec2 beside = clamp(pixel + around[i], ivec2(0), view.region.zw - 1);
        int count = samplesBeside(view, beside, nearness);
        if (count > most) best = beside;
        most = max(most, count);
    } while (++i < 8);
    return best;
}
#endif

void main() {
    SingleSampleBlock view = stored;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, view.region.zw))) return;
#ifdef RESOLVED
    vec4 value = texelFetch(resolved, view.region.xy + leastMixed(view, pixel), 0);
#else
    vec4 value = texelFetch(samples, view.region.xy + pixel, 0);
#endif
    imageStore(chosen, view.region.xy + pixel, value);
}
