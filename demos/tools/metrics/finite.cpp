#include "metrics/finite.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace demos {

namespace {

bool anyNotFinite(std::span<const float> values) {
    constexpr uint32_t exponent = 0x7f800000;
    uint32_t found = 0;
    for (const float value : values)
        found |= (std::bit_cast<uint32_t>(value) & exponent) == exponent ? 1u : 0u;
    return found != 0;
}

} // namespace

uint64_t countNotFinite(const PixelView& image, Infinity infinity) {
    if (!anyNotFinite(image.rgba)) return 0;
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

size_t firstNotFinite(const PixelView& image) {
    const auto broken = [](float value) { return !std::isfinite(value); };
    const auto first = std::find_if(image.rgba.begin(), image.rgba.end(), broken);
    return static_cast<size_t>(first - image.rgba.begin()) / 4;
}

} // namespace demos
