// One step of the foam history: what the cascade's breakers left fades, and what breaks now is white
// (water/foam/foam_history.h). A texel holds what is clear of foam at the step before
// and at this one, and two steps of plumes.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "foam_block.h"
#include "foam_fading.h"
#include "waves_bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = foamBinding, std140) uniform Foam {
    FoamBlock foam;
};
layout(set = 0, binding = displacementMapBinding) uniform sampler2DArray displacementMap;
layout(set = 0, binding = derivativeMapBinding) uniform sampler2DArray derivativeMap;
layout(set = 0, binding = foamStepsBinding, rgba16f) uniform image2DArray history;

// Where the cascade's waves are compressed past what they break at.
float breaksAt(vec3 at, FoamBand band) {
    float shear = textureLod(displacementMap, at, 0.0).w;
    vec2 stretch = textureLod(derivativeMap, at, 0.0).zw;
    float compression = -dot(foam.along.xyz, vec3(stretch, shear));
    return min((compression - band.foam.x) * band.foam.y, 1.0);
}

// What foam leaves clear, a step later.
float clearedFoam(float clear, FoamBand band) {
    float odds = (1.0 - clear) / (foamOddsScale - 1.0 + clear);
    odds = max((odds + band.foam.w) * band.foam.z - band.foam.w, 0.0);
    return (foamMostOdds - odds) / (foamMostOdds * (1.0 + odds));
}

// Many devices' stores cut off instead, and of what fades each step would lose as much.
vec2 nearestHalves(vec2 x) {
    uvec2 bits = floatBitsToUint(x);
    return uintBitsToFloat((bits + 0xfffu + (bits >> 13 & 1u)) & ~0x1fffu);
}

void main() {
    uint samples = uint(imageSize(history).x);
    ivec3 texel = ivec3(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y % samples, gl_GlobalInvocationID.y / samples);
    FoamBand band = foam.bands[texel.z];
    vec3 at = vec3((vec2(texel.xy) + 0.5) / float(samples) + band.drift.xy, texel.z);
    vec4 held = imageLoad(history, texel);
    float before = foam.foamAnew != 0u ? 1.0 : held.g;
    vec2 plume = foam.plumeAnew != 0u ? vec2(0.0) : held.ba;
    if (foam.plumes > 0u) {
        float now = max((plume.y + band.plume.y) * band.plume.x - band.plume.y, 0.0);
        for (uint tap = 0u; tap < foam.plumes; ++tap)
            now = max(now, breaksAt(vec3(at.xy + (float(tap) + 0.5) * band.plume.zw, at.z), band));
        plume = vec2(plume.y, now);
    }
    float clear = min(clearedFoam(before, band), 1.0 - breaksAt(at, band));
    vec2 stored = nearestHalves(vec2(clear, plume.y));
    imageStore(history, texel, vec4(before, stored.x, plume.x, stored.y));
}
