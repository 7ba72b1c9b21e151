// The sky of LightingDesc::skyZenith, as a host without a cube has it.
#pragma once

#include <glm/vec3.hpp>

#include "seaglass/host.h"

namespace seaglass {

/// On the plane with this unit normal in the world: what the host says, or of zeros and a null cube what the
/// sky's colours send.
glm::dvec3 skyIrradiance(const LightingDesc& lighting, const glm::dvec3& normal);

} // namespace seaglass
