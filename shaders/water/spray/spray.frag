// A cloud of drops: an ellipse that thins out to its rim, torn by eddies of the air that carries it. Clouds that overlap are torn
// by the same eddies: of each its own, their sum would be a soft blot. Light is scattered by what its optical depth there stops.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "body_constants.glsl"
#include "spray_constants.h"
#include "encoding.glsl"
#include "spray_block.h"
#include "hash.glsl"

layout(location = 0) in vec2 within;
layout(location = 1) flat in vec4 light;
layout(location = 2) flat in vec2 texture_;
layout(location = 3) in vec3 inAir;
layout(location = 4) in float overWaterline;
layout(location = 0) out vec4 outColor;

const int octaves = 6;   // the largest of a metre, each half as large as the one before

float cornerAt(ivec3 cell, int octave) {
    cell.xy &= (sprayAirRepeat << octave) - 1;
    return shareOf(scrambled(uint(cell.x) * 0x9e3779b9u ^ uint(cell.y) * 0x85ebca6bu ^ uint(cell.z) * 0xc2b2ae35u ^ uint(octave)));
}

// Of four corners at a height.
float layerAt(ivec3 cell, vec2 past, int octave) {
    return mix(mix(cornerAt(cell, octave), cornerAt(cell + ivec3(1, 0, 0), octave), past.x),
               mix(cornerAt(cell + ivec3(0, 1, 0), octave), cornerAt(cell + ivec3(1, 1, 0), octave), past.x), past.y);
}

float noiseAt(vec3 at, int octave) {
    vec3 whole = floor(at);
    ivec3 cell = ivec3(whole);
    vec3 past = at - whole;
    past *= past * (3.0 - 2.0 * past);
    return mix(layerAt(cell, past.xy, octave), layerAt(cell + ivec3(0, 0, 1), past.xy, octave), past.z);
}

// An octave that is finer than what shows is its mean.
float eddiesAt(vec3 at) {
    float sum = 0.5, wave = 1.0, weight = 0.26;
    int octave = 0;
    do {
        float shows = smoothstep(0.8, 2.0, wave / texture_.x);
        if (shows <= 0.0) break;
        sum += weight * shows * (noiseAt(at / wave, octave) - 0.5);
        wave *= 0.5;
        weight *= 0.9;
    } while (++octave < octaves);
    return sum;
}

void main() {
    float rim = 1.0 - dot(within, within);
    if (rim <= 0.0 || (straddles && overWaterline <= 0.0)) demote;
    // Torn, most so at the rim and where drops are few.
    float torn = smoothstep(0.4, mix(0.75, 0.65, texture_.y), eddiesAt(inAir) + 0.1 * (rim - 0.6));
    float depth = light.w * rim * rim * 3.4 * torn;
    float hides = 1.0 - exp(-depth);
    // Of encoded colour as much: clouds are brighter than the sea, and what they send counts, not what they dim.
    outColor = vec4(heldOf(light.rgb, targetIsEncoded), hides);
}
