// Which tiles of a reflection tiles.glsl says are looked up: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mirror_block.h"

// In place of mirror.glsl's.
#define MIRROR_GLSL
ivec2 reflectionSize(const MirrorBlock mirror) {
    return ivec2(64);
}
bool lookupsStray(const MirrorBlock mirror) {
    return false;
}
#include "tiles.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    ivec4 shown[];   // a window, and behind it the tile and the shift
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 lookedAt[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (2 * i + 1 >= shown.length()) return;
    MirrorBlock mirror;
    mirror.shown = shown[2 * i];
    mirror.pixelShift = shown[2 * i + 1].z;
    lookedAt[2 * i] = vec4(lookedUp(mirror, shown[2 * i + 1].xy, tileSeesPlane), lookedUp(mirror, shown[2 * i + 1].xy, 0u), 0.0, 0.0);
}
