// Opaque things under water, as they look from within it. The sun comes as photons bring it through the
// waves, by caustics.h, or where none were followed down the ray that calm water bends; the sky in beams
// likewise, which nothing hides, as in the host. The surface turns back what is sent up flatly: that light is
// taken to come from a level bed of the same albedo that is lit evenly.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

/// Where it is.
glm::vec3 shadeBed(const Frame& frame, const Ray& ray, const Hit& hit, Random* random);
/// Through the water that a ray which begins in it passes.
glm::vec3 bedInWater(const Frame& frame, const Ray& ray, const Hit& hit, Random* random);

} // namespace demos::reference
