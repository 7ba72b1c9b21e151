// From the primaries that a file states to those that everything here is in: Rec. 709's, white D65.
#pragma once

#include <array>
#include <optional>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos {

/// x and y of red, green, blue and white.
using Primaries = std::array<double, 8>;

constexpr Primaries rec709 = {0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329};
constexpr Primaries acesAp0 = {0.7347, 0.2653, 0, 1, 0.0001, -0.077, 0.32168, 0.33767};

/// White becomes white: adapted by Bradford's matrix (ICC.1:2010, annex E). Null when they span no colours.
std::optional<glm::dmat3> rec709From(const Primaries& primaries);

} // namespace demos
