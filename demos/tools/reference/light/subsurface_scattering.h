// Light through crests: shaders/water/surface/subsurface_scattering.glsl's, by rays through the displaced
// surface.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

/// `behind`, as it leaves the water, with what particles along the first `path` metres of a ray in the water
/// turn to it from the sun and the sky that they see through the surface. One point of the ray, at random, by
/// a copy of `random`, so that all else in a picture is as without. `plume`: of bubbles, which scatter, too.
glm::vec3 throughScattering(const Frame& frame, const Ray& ray, float path, const glm::vec3& behind,
                            float plume, Random random);

} // namespace demos::reference
