// Numbers that any host may hand over.
#pragma once

#include <algorithm>

namespace seaglass {

/// What is no number is the lowest.
template<typename T>
T heldIn(T low, T high, T value) {
    return std::min(std::max(low, value), high);
}

} // namespace seaglass
