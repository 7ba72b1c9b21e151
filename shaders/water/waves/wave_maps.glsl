// The maps of a body's waves, each of as many layers as there are cascades.
#ifndef WAVE_MAPS_GLSL
#define WAVE_MAPS_GLSL

#include "body.glsl"

layout(set = 0, binding = waveDisplacementBinding) uniform sampler2DArray waveDisplacement;
layout(set = 0, binding = waveDerivativesBinding) uniform sampler2DArray waveDerivatives;
layout(set = 0, binding = waveMomentsBinding) uniform sampler2DArray waveMoments;

// Before a loop: CPU devices load uniforms anew in each of its turns.
int waveCascades() {
    return cascades > 0 ? cascades : water.seaCascades;
}

#endif
