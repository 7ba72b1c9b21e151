// Colour as displays take it, as light.
#pragma once

#include <cmath>

#include "seaglass/host.h"

namespace tests {

inline double lightOf(float held, seaglass::Encoding encoding) {
    if (encoding == seaglass::Encoding::linear) return double{held};
    return held > 0.04045f ? std::pow((double{held} + 0.055) / 1.055, 2.4) : double{held} / 12.92;
}

} // namespace tests
