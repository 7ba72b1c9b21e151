// Ellipses by footprint.glsl: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "footprint.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    vec4 steps[];   // right, down
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 axes[];   // longer, shorter
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= steps.length()) return;
    Footprint ellipse = footprintOf(steps[i].xy, steps[i].zw);
    axes[i] = vec4(ellipse.longer, ellipse.shorter);
}
