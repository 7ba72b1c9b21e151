#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "draw.glsl"
#include "bent_sun.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;

layout(location = 0) out vec2 outUv;
layout(location = 1) out float outAlpha;
layout(location = 2) out vec3 outFromEye;

void main() {
    outUv = inUv;
    outAlpha = inColor.a;
    outFromEye = toEye(inPosition);
    // All of a triangle alike, which may reach out of the water: the fragment shader cuts it off there.
    const vec3 at = int(draw.surface.w) == castsBent ? sheared(outFromEye) : outFromEye;
    gl_Position = frame.shadowFromEye[int(draw.surface.z)] * vec4(at, 1.0);
}
