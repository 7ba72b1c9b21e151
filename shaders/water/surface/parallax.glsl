// Which point of the calm plane a pixel shows: where its line of sight meets the waves' own height instead of the mesh,
// which is too coarse for the short ones (parallax mapping, Kaneko et al. 2001). So waves' near sides are as large as
// their far sides are small.
#ifndef PARALLAX_GLSL
#define PARALLAX_GLSL

#include "surface_point.glsl"
#include "wave_displacement.glsl"

// `meshCalm` is the point that the mesh shows, `height` above calm water; two ways along the drawn triangle have the normal
// `across`, up or down.
vec2 shownCalm(vec2 meshCalm, Footprint pixel, vec3 position, float height, vec3 across) {
    if (!hasParallax) return meshCalm;
    float width = max(length(pixel.shorter), length(partOf(pixel)));
    float higher = waveDisplacementAt(waveDisplacement, meshCalm, width, vec4(1.0)).y - height;
    vec2 slope = -across.xz / (abs(across.y) > 1e-12 ? across.y : 1e-12);
    vec3 along = sightTo(position);
    float rises = abs(along.y - dot(slope, along.xz));   // of the line of sight over the triangle, to the eye
    return meshCalm - along.xz * (higher / max(rises, 0.02 * length(along.xz)));
}

#endif
