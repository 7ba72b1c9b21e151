// What is a little off in one place: too little for its pixels to be wrong, and too small for a mean over
// all.
#pragma once

#include <cstdint>
#include <span>

namespace demos {

struct Square {
    double mean = 0; ///< of the map
    uint32_t left = 0, top = 0;
};

/// The square of `side` pixels a side whose mean is greatest; the topmost of several. Of a picture that is
/// smaller one way, all of it that way. The map has one value a pixel, in rows of `width`.
Square worstSquare(std::span<const float> map, uint32_t width, uint32_t side);

} // namespace demos
