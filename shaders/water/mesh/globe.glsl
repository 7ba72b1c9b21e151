// A sea that falls away as on a ball under the eye's foot: water/mesh/globe.h.
#ifndef GLOBE_GLSL
#define GLOBE_GLSL

#include "body.glsl"

// Below the plane, at (u, v) from the eye's foot [m].
float globeDrop(vec2 calm) {
    if (!onGlobe) return 0.0;
    float drop = dot(calm, calm) * water.globeCurvature;
    return drop / (1.0 + sqrt(max(1.0 - drop * water.globeCurvature, 0.0)));
}

// Its columns are u, up and v of what is level at (u, v), in the body's axes: the smallest turn (Rodrigues).
mat3 levelAt(vec2 calm) {
    vec2 away = calm * water.globeCurvature;
    vec3 n = vec3(away.x, sqrt(max(1.0 - dot(away, away), 0.0)), away.y);
    float share = 1.0 / (1.0 + n.y);
    float both = -n.x * n.z * share;
    return mat3(1.0 - n.x * n.x * share, -n.x, both, n, both, -n.z, 1.0 - n.z * n.z * share);
}

#endif
