// Which fragments of the mesh are the surface's.
#ifndef SURFACE_CUT_GLSL
#define SURFACE_CUT_GLSL

#include "surface.glsl"
#include "exclusion_volumes.glsl"

layout(location = 2) flat in uvec2 edgeRange;   // of surface.vert

bool isSurface(vec2 calm, vec3 position) {
    // Of millions of pixels lavapipe gives the odd one to a triangle without area, with NaN for a depth.
    bool shows = gl_FragCoord.z > 0.0 && gl_FragCoord.z < 1.0 && !isExcluded(position);
    return isOutlined ? shows && isWithin(calm, edgeRange) : shows;
}

#endif
