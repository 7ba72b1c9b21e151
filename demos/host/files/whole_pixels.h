// Pixels of whole numbers, as PNG and JPEG hold them, as four floats each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos {

/// The greatest number is 1. `channels` of them make a pixel, and `from` says which are red, green, blue and
/// alpha; negative ones are not there. Grey is spread, other missing colours are 0, a missing alpha is 1.
void spreadWholes(const uint8_t* wholes, size_t channels, const std::array<int, 4>& from,
                  std::span<glm::vec4> to);
void spreadWholes(const uint16_t* wholes, size_t channels, const std::array<int, 4>& from,
                  std::span<glm::vec4> to);

} // namespace demos
