#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(location = 0) out vec3 outDirection;

void main() {
    const vec2 corner = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    outDirection = frame.skyForward.xyz + corner.x * frame.skyRight.xyz - corner.y * frame.skyUp.xyz;
    gl_Position = vec4(corner, 0.0, 1.0);   // depth 0: the far plane
}
