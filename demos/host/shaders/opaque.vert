#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "draw.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec2 inOtherUv[4];

layout(location = 0) out vec3 outFromEye;
layout(location = 1) out vec3 outNormal;
layout(location = 2) out vec2 outUv;
layout(location = 3) out vec4 outColor;
layout(location = 4) out vec2 outOtherUv[4];

void main() {
    outFromEye = toEye(inPosition);
    // The transform is a rotation and a uniform scale, which the fragment shader normalises away.
    outNormal = vec3(dot(draw.eyeFromMesh[0].xyz, inNormal), dot(draw.eyeFromMesh[1].xyz, inNormal),
                     dot(draw.eyeFromMesh[2].xyz, inNormal));
    outUv = inUv;
    outColor = inColor;
    outOtherUv = inOtherUv;
    gl_Position = frame.clipFromEye * vec4(outFromEye, 1.0);
}
