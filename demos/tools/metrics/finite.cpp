#include "metrics/finite.h"

#include <algorithm>
#include <cmath>

namespace demos {

uint64_t countNotFinite(const Image& image, Infinity infinity) {
    const auto sound = [infinity](float value) {
        return std::isfinite(value) || (infinity == Infinity::far && value == HUGE_VALF);
    };
    uint64_t count = 0;
    for (size_t i = 0; i < image.pixels(); ++i) {
        const std::span<const float> pixel = image.rgba.subspan(4 * i, 4);
        if (!std::all_of(pixel.begin(), pixel.end(), sound)) ++count;
    }
    return count;
}

bool isFinite(const Image& image, size_t pixel) {
    const float* const rgb = &image.rgba[4 * pixel];
    return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

} // namespace demos
