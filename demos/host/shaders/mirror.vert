#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "mirror.glsl"

layout(location = 0) out vec3 outFromEye;
layout(location = 1) out vec2 outUv;

// Counter-clockwise from the front.
const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(1, -1));

void main() {
    const vec2 corner = corners[gl_VertexIndex];
    outFromEye = mirror.middle.xyz + corner.x * mirror.across.xyz + corner.y * mirror.along.xyz;
    outUv = corner * vec2(mirror.across.w, mirror.along.w);
    gl_Position = frame.clipFromEye * vec4(outFromEye, 1.0);
}
