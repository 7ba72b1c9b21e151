// One step of the foam history: what the cascade's breakers left fades, and what breaks now is white
// (water/foam/foam_history.h). A texel holds the step before and this one.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "foam_block.h"
#include "waves_bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = foamBinding, std140) uniform Foam {
    FoamBlock foam;
};
layout(set = 0, binding = displacementMapBinding) uniform sampler2DArray displacementMap;
layout(set = 0, binding = derivativeMapBinding) uniform sampler2DArray derivativeMap;
layout(set = 0, binding = foamStepsBinding, rg16f) uniform image2DArray history;

void main() {
    uint samples = uint(imageSize(history).x);
    ivec3 at = ivec3(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y % samples, gl_GlobalInvocationID.y / samples);
    float shear = texelFetch(displacementMap, at, 0).w;
    vec2 stretch = texelFetch(derivativeMap, at, 0).zw;
    float compression = -dot(foam.along.xyz, vec3(stretch, shear));
    FoamBand band = foam.bands[at.z];
    float breaks = min((compression - band.threshold) * band.perCompression, 1.0);
    float before = foam.anew != 0u ? 0.0 : imageLoad(history, at).g;
    float faded = (before + band.floor) * band.fade - band.floor;
    imageStore(history, at, vec4(before, max(max(faded, breaks), 0.0), 0.0, 0.0));
}
