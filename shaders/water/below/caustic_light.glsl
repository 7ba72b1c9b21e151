// The picture of the light that the sun's rays leave: water/below/caustics.h.
#ifndef CAUSTIC_LIGHT_GLSL
#define CAUSTIC_LIGHT_GLSL

#include "body.glsl"

// Pixels from one ray to the next, and of a texel of light.
int rayStep() {
    return water.causticGrid.x;
}

// Pixels around the view from which rays come too.
int margin() {
    return water.causticGrid.y;
}

// Texels in the buffer, of which the view's come first.
int rowLength() {
    return water.causticGrid.z;
}

// Of texels, that may show what is below the horizon: in the margin too.
int firstRow() {
    return water.causticGrid.w;
}

const float lightUnit = 4096.0;   // of a texel as bright as under calm water
const float mostOfRay = 1e6;      // so that a sum of them stays within 32 bits

ivec2 lightSize() {
    return (regionSize() + rayStep() - 1) / rayStep();
}

// The pixel that stands for a texel, which may lie beside the view.
ivec2 pixelOfTexel(ivec2 texel) {
    return texel * rayStep() + rayStep() / 2;
}

// Over what slopes are taken together for a ray to `at` [m].
float rayWidth(vec3 at) {
    float width = 1.5 * float(rayStep()) * pixelWidth(at);
    return width > 1e-3 ? width : 1e-3;   // of a point at infinity it is no number
}

// Whether the scene shows something under the calm surface at a pixel of the region, and where.
bool bedShownAt(sampler2D sceneDepth, ivec2 pixel, out vec3 at) {
    float seen = texelFetch(sceneDepth, sceneTexel(pixel), 0).r;
    at = pointAt(vec2(pixel) + 0.5, seen);
    return !isFarPlane(seen) && heightOverCalm(at) < 0.0;
}

#endif
