#pragma once

#include <cstdint>
#include <vector>

namespace demos {

/// One float a pixel, top row first.
struct Plane {
    uint32_t width = 0, height = 0;
    std::vector<float> values;
};

/// Weights to either side of a centre: an odd number of them.
using Kernel = std::vector<float>;

/// Weighs the neighbours along x, then along y. Beyond an edge its pixel goes on.
Plane convolve(const Plane& plane, const Kernel& alongX, const Kernel& alongY);

} // namespace demos
