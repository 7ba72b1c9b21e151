// Takes sample 0 of each pixel of a multisampled image: reflection/single_sample.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2DMS samples;
#ifdef COLOR
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D chosen;
#else
layout(set = 0, binding = 2, r32f) uniform writeonly image2D chosen;
#endif

void main() {
    loadMirror();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, region.zw))) return;
    imageStore(chosen, region.xy + pixel, texelFetch(samples, region.xy + pixel, 0));
}
