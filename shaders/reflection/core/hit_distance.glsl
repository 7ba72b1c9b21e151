// How far from the mirror what a pixel shows is.
#ifndef HIT_DISTANCE_GLSL
#define HIT_DISTANCE_GLSL

#include "mirror.glsl"

// From the mirror to what is hit: the mirrored ray is as long below the plane as the way to its end.
float distanceToHit(const MirrorBlock mirror, vec2 q, float mirroredDepth) {
    vec3 end = unprojected(mirror, vec3(q, mirroredDepth));
    vec3 along = sightAt(mirror, end);
    return length(along) * heightOver(mirror, end) / dot(planeNormal(mirror), along);
}

#endif
