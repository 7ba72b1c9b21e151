// Where the near plane of a view that stands in both leaves the water.
#ifndef WATERLINE_GLSL
#define WATERLINE_GLSL

#include "body.glsl"
#include "wave_displacement.glsl"

// As the finest cells of the mesh have it.
vec3 displacementOf(vec2 calm) {
    return surfaceDisplacement(waveDisplacement, calm, water.finestCell);
}

// Of a point above the displaced surface [m]; waves move points sideways too, so what is above it is looked for.
float heightAboveSurface(vec3 at) {
    float height = heightOverCalm(at);
    if (!hasWaves) return height;
    vec2 calm = at.xz;
    for (int i = 0; i < 3; ++i) calm = at.xz - displacementOf(calm).xz;
    return height - displacementOf(calm).y;
}

#endif
