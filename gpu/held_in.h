// Numbers that any host may hand over.
#pragma once

#include <algorithm>
#include <cmath>

namespace seaglass {

/// What is no number is the lowest.
template<typename T>
T heldIn(T low, T high, T value) {
    return std::min(std::max(low, value), high);
}

/// On either side of 0, which stands for what is no number.
inline double heldWithin(double farthest, double value) {
    return std::isnan(value) ? 0 : heldIn(-farthest, farthest, value);
}

} // namespace seaglass
