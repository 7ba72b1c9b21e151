#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace demos {

/// The colour map of FLIP: black at 0 by purple and orange to pale yellow at 1, ever lighter. sRGB bytes.
std::array<uint8_t, 3> magma(float value);

/// RGB of a whole map.
std::vector<uint8_t> magma(std::span<const float> map);

} // namespace demos
