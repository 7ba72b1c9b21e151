// Where whitecaps are thick: water/interface/foam_gate.h, at its places and bits.
#ifndef FOAM_GATE_GLSL
#define FOAM_GATE_GLSL

#include "wave_warp.glsl"

float foamGateCorner(uvec2 cell, uint turns, uint now) {
    uint bits = cell.x * 0x9e3779b9u ^ cell.y * 0x85ebca6bu;
    bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du;
    bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
    bits ^= bits >> 15;
    uint phase = bits + (turns + ((bits & 255u) * turns >> 9)) * now;
    return abs(float(int(phase))) * 4.656613e-10;
}

// Of the first cascade, `place` from the eye on its plane [m], as a mean over `width`.
float foamGate(vec2 place, float width) {
    const float mean = 0.515;
    if (!isWarped) return 1.0;
    float blurred = smoothstep(0.5, 2.0, width * water.foamGate.z);
    ivec4 first = water.foamCell;
    vec2 at = water.foamGate.xy + place * water.foamGate.z;
    vec2 whole = floor(at);
    uvec2 cell = uvec2(first.xy) + uvec2(ivec2(whole));
    vec2 past = at - whole;
    past *= past * (3.0 - 2.0 * past);
    uint turns = uint(first.z), now = uint(first.w);
    float low = mix(foamGateCorner(cell, turns, now), foamGateCorner(cell + uvec2(1, 0), turns, now), past.x);
    float high = mix(foamGateCorner(cell + uvec2(0, 1), turns, now), foamGateCorner(cell + uvec2(1, 1), turns, now), past.x);
    return mix(mix(0.3, 1.0, smoothstep(0.5, 0.75, mix(low, high, past.y))), mean, blurred);
}

#endif
