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

// Where the cascade's waves are compressed past what they break at.
float breaksAt(vec3 at, FoamBand band) {
    float shear = textureLod(displacementMap, at, 0.0).w;
    vec2 stretch = textureLod(derivativeMap, at, 0.0).zw;
    float compression = -dot(foam.along.xyz, vec3(stretch, shear));
    return min((compression - band.foam.x) * band.foam.y, 1.0);
}

float fadedFoam(float white, FoamBand band) {
    float odds = max((white / (foamOddsScale - white) + band.foam.w) * band.foam.z - band.foam.w, 0.0);
    return foamOddsScale * odds / (1.0 + odds);
}

void main() {
    uint samples = uint(imageSize(history).x);
    ivec3 texel = ivec3(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y % samples, gl_GlobalInvocationID.y / samples);
    FoamBand band = foam.bands[texel.z];
    vec3 at = vec3((vec2(texel.xy) + 0.5) / float(samples) + band.drift.xy, texel.z);
    vec4 held = imageLoad(history, texel);
    float before = foam.foamAnew != 0u ? 0.0 : held.g;
    vec2 plume = foam.plumeAnew != 0u ? vec2(0.0) : held.ba;
    if (foam.plumes > 0u) {
        float now = max((plume.y + band.plume.y) * band.plume.x - band.plume.y, 0.0);
        for (uint look = 0u; look < foam.plumes; ++look)
            now = max(now, breaksAt(vec3(at.xy + (float(look) + 0.5) * band.plume.zw, at.z), band));
        plume = vec2(plume.y, now);
    }
    imageStore(history, texel, vec4(before, max(fadedFoam(before, band), breaksAt(at, band)), plume));
}
