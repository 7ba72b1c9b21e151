// Numbers of a lattice's cells as shaders hold them: modulo 2^32, for places as far away as one likes.
#pragma once

#include <cmath>
#include <cstdint>

namespace seaglass {

/// Of a whole number.
inline int32_t wrappedCell(double cell) {
    return static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(std::fmod(cell, 0x1p32))));
}

} // namespace seaglass
