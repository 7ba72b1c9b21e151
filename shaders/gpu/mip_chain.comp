// Up to five halvings of some image arrays at once: means of 2 x 2 texels, which are what a linear filter gives. A group takes
// a square of 32 x 32 texels and keeps what it has halved in shared memory (after AMD's single pass downsampler).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mip_chain_block.h"

layout(local_size_x = 16, local_size_y = 16) in;

layout(set = 0, binding = mipChainBinding, std140) uniform MipChain {
    MipChainBlock settings;
};
#define HALVED(binding_, name) layout(set = 0, binding = binding_, FORMAT) uniform writeonly image2DArray name;
// `i` counts the images.
#define IMAGE(i, source, a, b, c, d, e)                                                                                \
    layout(set = 0, binding = firstSourceBinding + i) uniform sampler2DArray source;                                   \
    HALVED(firstHalvedBinding + 5 * i + 0, a)                                                                          \
    HALVED(firstHalvedBinding + 5 * i + 1, b)                                                                          \
    HALVED(firstHalvedBinding + 5 * i + 2, c)                                                                          \
    HALVED(firstHalvedBinding + 5 * i + 3, d)                                                                          \
    HALVED(firstHalvedBinding + 5 * i + 4, e)
IMAGE(0, first, first1, first2, first3, first4, first5)
#if IMAGES == 3
IMAGE(1, second, second1, second2, second3, second4, second5)
IMAGE(2, third, third1, third2, third3, third4, third5)
#endif

shared vec4 means[16][16];

vec4 meanOf(sampler2DArray source, ivec3 texel) {
    ivec3 at = ivec3(2 * texel.xy, texel.z);
    return 0.25 * (texelFetch(source, at, 0) + texelFetch(source, at + ivec3(1, 0, 0), 0) +
                   texelFetch(source, at + ivec3(0, 1, 0), 0) + texelFetch(source, at + ivec3(1, 1, 0), 0));
}

vec4 meanOfFour(ivec2 at) {
    return 0.25 * (means[at.y][at.x] + means[at.y][at.x + 1] + means[at.y + 1][at.x] + means[at.y + 1][at.x + 1]);
}

// A group is of one image: all of it goes the same way.
#if IMAGES == 3
#define STORE(a, b, c, texel, mean)                                                                                    \
    if (image == 0) imageStore(a, texel, mean);                                                                        \
    else if (image == 1) imageStore(b, texel, mean);                                                                   \
    else imageStore(c, texel, mean);
#else
#define STORE(a, b, c, texel, mean) imageStore(a, texel, mean);
#endif

// All of the group come here, or none: it waits for what it has left in shared memory.
#define HALVE(level, a, b, c)                                                                                          \
    if (settings.levels < level) return;                                                                               \
    barrier();                                                                                                         \
    edge >>= 1;                                                                                                        \
    takesPart = all(lessThan(local, ivec2(edge)));                                                                     \
    if (takesPart) mean = meanOfFour(2 * local);                                                                       \
    barrier();                                                                                                         \
    if (takesPart) {                                                                                                   \
        means[local.y][local.x] = mean;                                                                                \
        ivec2 texel = ivec2(gl_WorkGroupID.xy) * edge + local;                                                         \
        if (all(lessThan(texel, size >> level))) STORE(a, b, c, ivec3(texel, layer), mean)                             \
    }

void main() {
    ivec3 shape = textureSize(first, 0);
    ivec2 size = shape.xy;
    int image = int(gl_WorkGroupID.z) / shape.z;
    int layer = int(gl_WorkGroupID.z) - image * shape.z;
    ivec2 local = ivec2(gl_LocalInvocationID.xy);
    int edge = 16;
    ivec3 texel = ivec3(ivec2(gl_WorkGroupID.xy) * edge + local, layer);
    bool takesPart = all(lessThan(texel.xy, size >> 1));
    vec4 mean = vec4(0.0);
    if (takesPart) {
#if IMAGES == 3
        if (image == 1) mean = meanOf(second, texel);
        else if (image == 2) mean = meanOf(third, texel);
        else
#endif
            mean = meanOf(first, texel);
        STORE(first1, second1, third1, texel, mean)
    }
    means[local.y][local.x] = mean;
    HALVE(2, first2, second2, third2)
    HALVE(3, first3, second3, third3)
    HALVE(4, first4, second4, third4)
    HALVE(5, first5, second5, third5)
}
