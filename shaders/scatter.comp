// SSPR, first pass: every scene pixel above the plane leaves its mirrored depth where the plane would show it. Only
// depth is stored, since the mirror is an involution and leads back to the source; atomicMax commutes, so the result
// does not depend on the order of the invocations.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) buffer Keys {
    uint keys[];
};

const int rowsPerInvocation = 4;

void scatter(ivec2 pixel) {
    float depth = texelFetch(sceneDepth, region.xy + pixel, 0).r;
    if (isFar(depth)) return;
    vec3 source = vec3(vec2(pixel) + 0.5, depth);
    if (heightAbovePlane(source) <= contactHeight(source)) return;
    vec4 target = mirrored(source);
    if (!(target.w > 0.0) || !(target.z > 0.0 && target.z <= 1.0) || !insideRegion(target.xy)) return;
    ivec2 q = ivec2(target.xy);
    atomicMax(keys[q.y * region.z + q.x], keyFromDepth(target.z));
}

void main() {
    ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, rowsPerInvocation);
    if (first.x >= region.z) return;
    for (int row = 0; row < rowsPerInvocation; ++row)
        if (first.y + row < region.w) scatter(first + ivec2(0, row));
}
