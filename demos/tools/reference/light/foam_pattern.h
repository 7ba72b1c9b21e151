// The pattern that foam breaks up into, as shaders/water/foam/foam_cover.glsl draws it.
#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "reference/water_surface.h"

namespace demos::reference {

struct Foam {
    float mask = 0;     ///< share of the surface that is white
    float fresh = 0;    ///< 1 where waves break, less as what they leave thins
    glm::vec2 slope{0}; ///< of its own bumps
    float height = 0;   ///< of the white's own, -1..1
    float plume = 0;    ///< bubbles in the water below
};

/// `pixelWidth` is in metres of calm water.
Foam foamAt(const WaterSurface& surface, const glm::dvec2& calm, float pixelWidth);

} // namespace demos::reference
