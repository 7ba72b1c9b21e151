// Where lines of sight begin.
#ifndef NEAR_PLANE_GLSL
#define NEAR_PLANE_GLSL

#include "body.glsl"

// Of the one through a pixel of the region, relative to the eye.
vec3 onNearPlane(vec2 pixel) {
    float nearDepth = nearerIsGreater() ? 1.0 : 0.0;
    return pointAt(pixel, nearDepth);
}

// How deep in the water the line of sight begins that leaves the near plane there: at the eye, if there is one [m].
float depthOfSight(vec3 start) {
    return max(calmLevel() - sightStart(start).y, 0.0);
}

#endif
