// What a ray brings back: sky, opaque things and water.
//
// Water is traced with one reflected and one refracted ray a bounce, each with the exact Fresnel term. With
// one sample a pixel the slope is the mean over the pixel and the sun's glint is the shader's formula: a
// sharp picture of where things are mirrored, not of how rough water looks. With more, each sample takes the
// slope of a point, tilts it at random by what no map resolves, and counts by the area that the eye sees of
// such a facet; the glint then comes from a point of the sun's disc and the density of the facets that mirror
// it, which is what a great many random tilts would find.
//
// Light scattered by the water follows shaders/water/body/water_light.glsl; what lies below is lit by
// shade_bed.h. Light through crests, by subsurface_scattering.h, is left out of one sample a pixel.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

constexpr int mostBounces = 3; ///< of a path between waves

struct WaterRadiance {
    glm::vec3 radiance{0}; ///< times weight
    float weight = 1;
};

/// `random` is null for one sample a pixel.
WaterRadiance shadeWater(const Frame& frame, const Ray& ray, const Hit& hit, int bounces, Random* random);
glm::vec3 shadeHit(const Frame& frame, const Ray& ray, const Hit& hit, Random* random); ///< opaque
glm::vec3 radianceAlong(const Frame& frame, const Ray& ray, int bounces, Random* random);

/// The slope over the pixel's footprint, and where its mirror turns the ray; where that mean faces away from
/// the eye, the mesh's own normal serves.
struct MirroredRay {
    glm::vec3 normal;
    Ray ray;
};
MirroredRay mirrorOfMean(const Frame& frame, const Ray& ray, const Hit& hit);

} // namespace demos::reference
