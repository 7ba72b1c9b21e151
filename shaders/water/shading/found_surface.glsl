// What found_surface.frag leaves of the surface in a view: its depth, 1 at the near plane and down to 0 where nothing is, and how
// far waves have moved to the side what shows there, as shares of the farthest that any do. Of the view, which images may be larger than.
#ifndef FOUND_SURFACE_GLSL
#define FOUND_SURFACE_GLSL

#include "body.glsl"

float farthestAside() {
    return water.found.x;
}

vec2 movedAside(uint held) {
    return farthestAside() * unpackSnorm2x16(held);
}

uint heldAside(vec2 moved) {
    return packSnorm2x16(moved * water.found.y);
}

// As the host's depth runs.
float hostDepth(float found) {
    return nearerIsGreater() ? found : 1.0 - found;
}

// That a depth of the host's scene lies before what was found. Depth that is a copy in coarser texels may tell a little less than what
// the host tests by.
bool liesBefore(float scene, float found) {
    const float doubt = 1e-3;
    return depthBefore(scene, hostDepth(found)) > doubt * found;
}

#endif
