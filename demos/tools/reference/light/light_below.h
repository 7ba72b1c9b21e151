// Sun and sky as they light what lies under calm water, by beams that its surface bends.
#pragma once

#include <array>

#include "reference/light/light.h"

namespace demos::reference {

struct Beam {
    glm::vec3 from{0, 1, 0}; ///< unit, in the water: where it comes from
    glm::vec3 irradiance{0}; ///< just below the surface, on a plane that faces it
};

/// What the surface lets in of light from the direction `from` in air, of this irradiance on the level.
Beam enteringBeam(const glm::vec3& from, const glm::vec3& irradiance);

/// Of the sky: each an equal share of the directions, as a level plane counts them.
using SkyBeams = std::array<Beam, 32>;
SkyBeams skyBeams(const Light& light);

} // namespace demos::reference
