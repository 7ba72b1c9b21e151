// One facet of the water's surface as a ray meets it, from either side.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

struct Facet {
    WaterSurface::Slopes slopes;
    glm::vec3 normal{0, 1, 0}; ///< towards the ray
    glm::vec3 up{0, 1, 0};     ///< of the mesh, towards the ray
    float meshCosine = 1;      ///< what the eye sees of a horizontal square metre of the mesh
    float weight = 1;
};

/// Width of the pixel on the calm surface around a hit [m].
float footprintOn(const Ray& ray, const Hit& hit);
/// Over which foam is a mean there [m]: the pixel, but of many samples each sees the white or the dark of its
/// own point.
float foamWidth(const Ray& ray, const Hit& hit, const Random* random);

/// The mean slope over the pixel; where that faces away from the eye, the mesh's own.
Facet meanFacet(const Frame& frame, const Ray& ray, const Hit& hit);
/// The slope of the point, tilted at random by what no map resolves.
Facet randomFacet(const Frame& frame, const Ray& ray, const Hit& hit, float leastCosine, Random& random);

/// On from a hit, to the side that `side` points to.
Ray bentRay(const Ray& ray, const Hit& hit, const glm::vec3& side, const glm::vec3& direction);

} // namespace demos::reference
