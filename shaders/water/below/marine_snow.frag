// A particle in the water: round, and thin at its rim.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "constant.glsl"
#include "body_constants.h"
#include "encoding.glsl"

layout(location = 0) in vec2 within;
layout(location = 1) flat in vec4 light;
layout(location = 0) out vec4 outColor;

void main() {
    float rim = 1.0 - dot(within, within);
    if (rim <= 0.0) demote;
    float hides = light.a * rim;
    // What shows through dims as light does.
    if (targetIsEncoded) hides = 1.0 - heldGrowth(vec3(1.0 - hides)).x;
    outColor = vec4(heldOf(light.rgb, targetIsEncoded), hides);
}
