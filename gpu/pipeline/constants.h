// What structs of specialisation constants need: gpu/pipeline/constants.inl.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace seaglass {

using uint = uint32_t; ///< as GLSL has it

namespace gpu {

/// 0, 1, 2...
constexpr bool areCounted(std::span<const uint32_t> numbers) {
    for (uint32_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != i) return false;
    return true;
}

} // namespace gpu

} // namespace seaglass
