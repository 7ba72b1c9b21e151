// What hosts' shaders are told of the sand at some places: shore_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 64) in;

layout(set = 0, binding = 1, std430) readonly buffer ShoreRows {
    vec4 shoreRows[];
};

vec4 seaglass_shoreRow(int row) {
    return shoreRows[row];
}

#include "shore_wetness.glsl"

layout(set = 0, binding = 0, std430) readonly buffer Places {
    SeaglassShore shore;
    vec4 places[];   // (u, v) from the eye, height
};
layout(set = 0, binding = 2) uniform sampler2D shoreMap;
layout(set = 0, binding = 3, std430) writeonly buffer Wet {
    vec2 wet[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < places.length()) wet[i] = seaglass_wetness(shore, shoreMap, places[i].xy, places[i].z);
}
