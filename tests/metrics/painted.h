// Pictures for the tests of the measures.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "demos/tools/metrics/image.h"

namespace tests {

/// An image that owns its pixels.
class Painted {
  public:
    uint32_t width = 0, height = 0;
    std::vector<float> rgba;

    Painted() = default;
    Painted(uint32_t w, uint32_t h, std::vector<float> pixels)
        : width(w), height(h), rgba(std::move(pixels)) {}

    demos::PixelView view() const { return {width, height, rgba}; }
    float& at(int x, int y, int channel) { return rgba[index(x, y, channel)]; }
    float at(int x, int y, int channel) const { return rgba[index(x, y, channel)]; }

  private:
    size_t index(int x, int y, int channel) const {
        const size_t pixel = static_cast<size_t>(y) * width + static_cast<size_t>(x);
        return 4 * pixel + static_cast<size_t>(channel);
    }
};

/// `value(x, y, channel)` of red, green and blue; alpha is 1.
Painted painted(int width, int height, const std::function<float(int, int, int)>& value);

Painted grey(int width, int height, float value = 0.5f);

/// Soft shapes and a hard-edged mast, a little like a harbour: something to blur, shift and leave out.
Painted harbour();

} // namespace tests
