// A particle in the water: round, and thin at its rim.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "body_constants.glsl"
#include "encoding.glsl"

layout(location = 0) in vec2 within;
layout(location = 1) flat in vec4 light;
layout(location = 2) flat in vec3 behind;
layout(location = 0) out vec4 outColor;

// Blended as displays take colour, so much makes endless water as light as it would be.
float hiddenOfHeld(float hides) {
    vec3 before = heldOf(behind, true);
    vec3 changes = heldOf(mix(behind, light.rgb, hides), true) - before, most = heldOf(light.rgb, true) - before;
    float all = dot(most, vec3(1.0));
    return abs(all) > 1e-4 ? clamp(dot(changes, vec3(1.0)) / all, 0.0, 1.0) : hides;
}

void main() {
    float rim = 1.0 - dot(within, within);
    if (rim <= 0.0) demote;
    float hides = light.a * rim;
    outColor = vec4(heldOf(light.rgb, targetIsEncoded), targetIsEncoded ? hiddenOfHeld(hides) : hides);
}
