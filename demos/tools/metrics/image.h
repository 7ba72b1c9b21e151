#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace demos {

/// A view of float RGBA pixels, top row first: 4 * width * height values.
struct PixelView {
    uint32_t width = 0, height = 0;
    std::span<const float> rgba;

    size_t pixels() const { return size_t{width} * height; }
};

/// A pixel, from the upper left.
struct Place {
    uint32_t x = 0, y = 0;
};

} // namespace demos
