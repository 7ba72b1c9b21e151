// How far the water at a pixel has come in the picture since the last frame.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface.glsl"

layout(location = 0) in vec2 calmPosition;
layout(location = 1) in vec3 position;
layout(location = 3) in vec4 lastPixel;
layout(location = 0) out vec4 outColor;

#include "exclusion_volumes.glsl"
#include "surface_cut.glsl"

void main() {
    if (!isSurface(calmPosition, position)) demote;
    vec2 here = regionPixel(gl_FragCoord.xy);
    vec2 moved = lastPixel.w > 0.0 ? here - lastPixel.xy / lastPixel.w : vec2(0.0);   // it was behind the eye
    outColor = vec4(moved, 0.0, 1.0);
}
