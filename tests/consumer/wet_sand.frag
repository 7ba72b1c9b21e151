// A host's own sand, wetted by the waves of a shore, by no shader of ours but what is installed for it: docs/surface.md.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(binding = 0) uniform sampler2D shoreMap;   // seaglass::shoreTexels()
layout(binding = 1, std430) readonly buffer ShoreRows {
    vec4 shoreRows[];   // seaglass::shoreRows()
};

vec4 seaglass_shoreRow(int row) {
    return shoreRows[row];
}

#include "shore_wetness.glsl"

layout(binding = 2, std140) uniform Shore {
    SeaglassShore shore;   // seaglass::ShoreBlock
    float eyeHeight;       // over the calm water
} sand;

layout(location = 0) in vec3 fromEye;
layout(location = 1) in vec3 light;
layout(location = 0) out vec4 outColor;

void main() {
    const vec2 wet = seaglass_wetness(sand.shore, shoreMap, fromEye.xz, fromEye.y + sand.eyeHeight);
    const vec3 albedo = seaglass_wetAlbedo(vec3(0.6, 0.5, 0.3), wet);
    outColor = vec4(albedo * light, seaglass_wetRoughness(1.0, wet));
}
