// One step of the foam history: what the cascade's breakers left fades, and what breaks now is white
// (water/foam/foam_history.h). A texel holds the step before and this one, and two steps of plumes.
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

float compressionAt(ivec3 texel) {
    float shear = texelFetch(displacementMap, texel, 0).w;
    vec2 stretch = texelFetch(derivativeMap, texel, 0).zw;
    return -dot(foam.along.xyz, vec3(stretch, shear));
}

// How far the cascade's waves, so many tiles aside, are compressed past what they break at. Filters of devices weigh texels by
// eight bits, which is too little.
float breaksAside(ivec3 texel, vec2 tiles, FoamBand band) {
    int samples = imageSize(history).x;   // a power of two
    vec2 way = tiles * float(samples);
    vec2 whole = floor(way);
    vec2 past = way - whole;
    ivec2 low = (texel.xy + ivec2(whole)) & (samples - 1);
    ivec2 high = (low + 1) & (samples - 1);
    float here = mix(compressionAt(ivec3(low, texel.z)), compressionAt(ivec3(high.x, low.y, texel.z)), past.x);
    float next = mix(compressionAt(ivec3(low.x, high.y, texel.z)), compressionAt(ivec3(high, texel.z)), past.x);
    return min((mix(here, next, past.y) - band.foam.x) * band.foam.y, 1.0);
}

float fadedFoam(float white, FoamBand band) {
    float odds = max((white / (foamOddsScale - white) + band.foam.w) * band.foam.z - band.foam.w, 0.0);
    return foamOddsScale * odds / (1.0 + odds);
}

void main() {
    uint samples = uint(imageSize(history).x);
    ivec3 texel = ivec3(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y % samples, gl_GlobalInvocationID.y / samples);
    FoamBand band = foam.bands[texel.z];
    vec4 held = imageLoad(history, texel);
    float before = foam.foamAnew != 0u ? 0.0 : held.g;
    vec2 plume = foam.plumeAnew != 0u ? vec2(0.0) : held.ba;
    if (foam.plumes > 0u) {
        float now = max((plume.y + band.plume.y) * band.plume.x - band.plume.y, 0.0);
        for (uint look = 0u; look < foam.plumes; ++look)
            now = max(now, breaksAside(texel, band.drift.xy + (float(look) + 0.5) * band.plume.zw, band));
        plume = vec2(plume.y, now);
    }
    imageStore(history, texel, vec4(before, max(fadedFoam(before, band), breaksAside(texel, band.drift.xy, band)), plume));
}
