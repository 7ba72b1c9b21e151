// Fog along rays in the air, by the formula that host and water have.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

/// What is left of `radiance` at the end of `way` metres from a point relative to the eye, with what fog
/// adds; `weight` is what `radiance` has been multiplied with.
glm::vec3 throughAir(const Frame& frame, const glm::vec3& from, const glm::vec3& direction, float way,
                     const glm::vec3& radiance, float weight = 1);

/// From where a line of sight begins: the eye, or the near plane of parallel lines.
glm::vec3 throughAirToEye(const Frame& frame, const Ray& ray, const Hit& hit, const glm::vec3& radiance,
                          float weight = 1);

/// Where fog lies over the sky, which is as far away as can be.
glm::vec3 skyThroughAir(const Frame& frame, const glm::vec3& from, const glm::vec3& direction,
                        const glm::vec3& sky);

} // namespace demos::reference
