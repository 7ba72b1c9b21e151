#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "draw.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;

layout(location = 0) out vec2 outUv;
layout(location = 1) out float outAlpha;

void main() {
    outUv = inUv;
    outAlpha = inColor.a;
    gl_Position = frame.shadowFromEye[int(draw.surface.z)] * vec4(toEye(inPosition), 1.0);
}
