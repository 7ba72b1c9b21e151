// How many cells and blocks cells.glsl lays over a picture: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mirror_block.h"

// In place of mirror.glsl's.
#define MIRROR_GLSL
ivec2 regionSize(const MirrorBlock mirror) {
    return mirror.region.zw;
}
#include "cells.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    ivec4 sizes[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 squares[];   // across and down: cells, then blocks
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= sizes.length()) return;
    MirrorBlock mirror;
    mirror.region = sizes[i].zwxy;
    squares[i] = vec4(squaresAcross(mirror, cellShift), squaresDown(mirror, cellShift), squaresAcross(mirror, blockShift),
                      squaresDown(mirror, blockShift));
}
