// The pattern that foam breaks up into, as shaders/surface.frag draws it.
#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos::reference {

/// Share of the surface that is white, for a share `cover` that breaks. `pixelWidth` is in metres of calm
/// water.
float foamMask(const glm::dvec2& calm, float pixelWidth, float cover);

} // namespace demos::reference
