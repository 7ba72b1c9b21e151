// How far apart two pictures of bytes are.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <span>

namespace tests {

/// Mean of all channels' absolute differences, of 255. Both are of one size.
inline double meanDifference(std::span<const uint8_t> a, std::span<const uint8_t> b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

} // namespace tests
