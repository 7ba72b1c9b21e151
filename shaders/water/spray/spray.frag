// A cloud of drops: an ellipse of noise that thins out to its rim, drawn out along its flight. Light is scattered by what its
// optical depth there stops.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "body_constants.glsl"
#include "encoding.glsl"
#include "value_noise.glsl"

layout(location = 0) in vec2 within;
layout(location = 1) flat in vec4 light;
layout(location = 2) flat in vec4 texture_;
layout(location = 3) flat in uint seed;
layout(location = 0) out vec4 outColor;

float noiseAt(vec2 at, uint of) {
    vec2 whole = floor(at);
    return noiseWithin(ivec2(whole), at - whole, of);
}

// An octave that is finer than what shows is its mean.
float octave(vec2 at, float wave, uint of) {
    float shows = smoothstep(0.5, 1.5, wave / texture_.z);
    return shows > 0.0 ? mix(0.5, noiseAt(at / (wave * vec2(3.0, 1.0)), of), shows) : 0.5;
}

void main() {
    float rim = 1.0 - dot(within, within);
    if (rim <= 0.0) demote;
    vec2 at = within * texture_.xy;
    float widest = 0.9 * texture_.y;
    float noise = 0.45 * octave(at, widest, seed) + 0.3 * octave(at, 0.4 * widest, seed + 1u) + 0.25 * octave(at, 0.16 * widest, seed + 2u);
    // Torn, most so at the rim and where drops are few.
    float torn = smoothstep(0.35, mix(0.8, 0.65, texture_.w), noise + 0.2 * (rim - 0.6));
    float depth = light.w * rim * rim * 2.4 * torn;
    float hides = 1.0 - exp(-depth);
    // Of encoded colour as much: clouds are brighter than the sea, and what they send counts, not what they dim.
    outColor = vec4(heldOf(light.rgb, targetIsEncoded), hides);
}
