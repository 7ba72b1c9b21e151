#version 460
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"

layout(set = 1, binding = 0) uniform sampler2D baseColorMap;

layout(location = 0) in vec2 inUv;
layout(location = 1) in float inAlpha;

void main() {
    if (draw.baseColor.a * inAlpha * texture(baseColorMap, inUv).a < draw.emissive.w) discard;
}
