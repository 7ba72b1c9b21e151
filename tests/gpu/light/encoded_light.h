// Colour as displays take it, as light.
#pragma once

#include <cmath>

#include "tests/gpu/rig/water_rig.h"

namespace tests {

inline double lightOf(float held, seaglass::Encoding encoding) {
    if (encoding == seaglass::Encoding::linear) return double{held};
    return held > 0.04045f ? std::pow((double{held} + 0.055) / 1.055, 2.4) : double{held} / 12.92;
}

/// That a picture has more than another, red, in the pixels in which that shows any.
inline double lightAdded(const WaterPicture& with, const WaterPicture& without, seaglass::Encoding encoding) {
    double sum = 0;
    for (size_t i = 0; i < with.color.size(); i += 4)
        if (without.color[i] > 0)
            sum += lightOf(with.color[i], encoding) - lightOf(without.color[i], encoding);
    return sum;
}

} // namespace tests
