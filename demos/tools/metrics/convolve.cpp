#include "metrics/convolve.h"

#include <algorithm>
#include <cstddef>

namespace demos {

namespace {

void addScaled(float* to, const float* from, float weight, size_t count) {
    for (size_t i = 0; i < count; ++i) to[i] += weight * from[i];
}

void convolveRow(const float* row, size_t width, const Kernel& kernel, std::vector<float>& padded,
                 float* out) {
    const size_t radius = kernel.size() / 2;
    padded.assign(width + 2 * radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
    for (size_t k = 0; k < kernel.size(); ++k) addScaled(out, &padded[k], kernel[k], width);
}

} // namespace

Plane convolve(const Plane& plane, const Kernel& alongX, const Kernel& alongY) {
    const size_t width = plane.width, height = plane.height, radius = alongY.size() / 2;
    Plane across{plane.width, plane.height, std::vector<float>(plane.values.size())};
    Plane result = across;
    std::vector<float> padded;
    for (size_t y = 0; y < height; ++y) {
        convolveRow(&plane.values[y * width], width, alongX, padded, &across.values[y * width]);
    }
    for (size_t y = 0; y < height; ++y) {
        for (size_t k = 0; k < alongY.size(); ++k) {
            const size_t from = std::clamp(y + k, radius, radius + height - 1) - radius;
            addScaled(&result.values[y * width], &across.values[from * width], alongY[k], width);
        }
    }
    return result;
}

} // namespace demos
