#include "metrics/outlier.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "metrics/finite.h"

namespace demos {

namespace {

constexpr float timesAsBright = 2;

/// Of the greatest channel, of what is finite.
float medianLight(const PixelView& image) {
    std::vector<float> light;
    light.reserve(image.pixels());
    for (size_t i = 0; i < image.pixels(); ++i) {
        const float* const pixel = &image.rgba[4 * i];
        if (isFinite(image, i)) light.push_back(std::max({pixel[0], pixel[1], pixel[2], 0.0f}));
    }
    if (light.empty()) return 0;
    const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
    std::nth_element(light.begin(), middle, light.end());
    return *middle;
}

/// How far the nine pixels there go in a channel, upwards or downwards from 0.
float reach(const PixelView& image, size_t pixel, size_t channel, bool below) {
    const size_t x = pixel % image.width, y = pixel / image.width;
    float most = 0;
    for (size_t row = y - std::min<size_t>(y, 1); row <= std::min<size_t>(y + 1, image.height - 1); ++row) {
        for (size_t at = x - std::min<size_t>(x, 1); at <= std::min<size_t>(x + 1, image.width - 1); ++at) {
            const float value = image.rgba[4 * (row * image.width + at) + channel];
            if (std::isfinite(value)) most = std::max(most, below ? -value : value);
        }
    }
    return most;
}

bool isOutlier(const PixelView& of, const PixelView& other, size_t pixel, float median) {
    for (size_t channel = 0; channel < 3; ++channel) {
        const float value = of.rgba[4 * pixel + channel], same = other.rgba[4 * pixel + channel];
        const bool below = value < 0;
        const auto isOver = [&](float size) { return std::abs(value) > timesAsBright * size + median; };
        // Almost all pixels are like their own counterpart.
        if (!std::isfinite(value) || !isOver(std::max(below ? -same : same, 0.0f))) continue;
        if (isOver(reach(other, pixel, channel, below))) return true;
    }
    return false;
}

} // namespace

Outliers findOutliers(const PixelView& reference, const PixelView& test) {
    Outliers found;
    const float median = medianLight(reference);
    for (size_t i = 0; i < reference.pixels(); ++i) {
        if (!isOutlier(test, reference, i, median) && !isOutlier(reference, test, i, median)) continue;
        if (found.pixels++ == 0)
            found.first = {static_cast<uint32_t>(i % reference.width),
                           static_cast<uint32_t>(i / reference.width)};
    }
    return found;
}

} // namespace demos
