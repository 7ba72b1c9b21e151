// Pictures of values that are not light, as bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "host/host.h"

namespace demos {

using Rgb = std::array<float, 3>;

/// What `toRgb` makes of each pixel's values, 0..1; NaN is black.
template<class ToRgb>
std::vector<uint8_t> painted(const Picture& picture, const ToRgb& toRgb) {
    std::vector<uint8_t> bytes;
    bytes.reserve(picture.rgba.size() / 4 * 3);
    for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
        const Rgb color = toRgb(&picture.rgba[i]);
        for (const float value : color) // NaN fails the comparison
            bytes.push_back(value > 0 ? static_cast<uint8_t>(std::lround(std::min(value, 1.0f) * 255))
                                      : uint8_t{0});
    }
    return bytes;
}

/// Of values that are colours.
inline std::vector<uint8_t> paintedAsIs(const Picture& picture) {
    return painted(picture, [](const float* p) { return Rgb{p[0], p[1], p[2]}; });
}

} // namespace demos
