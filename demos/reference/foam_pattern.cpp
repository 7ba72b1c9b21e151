#include "reference/foam_pattern.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Not public: the pattern is the library's own, and there is to be but one.
#include "water/foam_pattern.h"
#include "water/surface.h"

namespace demos::reference {
namespace {

float patternAt(const glm::dvec2& calm, double tile) {
    static const std::vector<uint8_t> pattern = seaglass::foamPattern();
    constexpr auto size = int64_t(seaglass::foamPatternSamples);
    const glm::dvec2 p = calm / tile;
    const double x = (p.x - std::floor(p.x)) * size - 0.5, y = (p.y - std::floor(p.y)) * size - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto at = [&](double i, double j) {
        const auto column = static_cast<size_t>((static_cast<int64_t>(i) + size) % size);
        const auto row = static_cast<size_t>((static_cast<int64_t>(j) + size) % size);
        return static_cast<float>(pattern[row * size + column]) / 255;
    };
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    return glm::mix(glm::mix(at(x0, y0), at(x0 + 1, y0), fx),
                    glm::mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
}

/// How much of an octave of the pattern a pixel still shows; the rest is its mean.
float octaveShown(double tile, float pixelWidth) {
    const float texels = pixelWidth * static_cast<float>(seaglass::foamPatternSamples / tile);
    return 1 - std::clamp(0.5f * std::log2(std::max(texels, 1.0f)), 0.0f, 1.0f);
}

} // namespace

float foamMask(const glm::dvec2& calm, float pixelWidth, float cover) {
    constexpr float weights[] = {0.35f, 0.4f, 0.25f};
    constexpr double tiles[] = {seaglass::foamTile, seaglass::foamTile / 5, seaglass::foamTile / 17};
    float pattern = 0, variance = 1e-5f;
    for (size_t i = 0; i < 3; ++i) {
        const float weight = weights[i] * octaveShown(tiles[i], pixelWidth);
        if (weight > 0) pattern += weight * (patternAt(calm, tiles[i]) - 0.5f);
        variance += weight * weight / 12;
    }
    const float even = 1 / (1 + std::exp(-1.702f * pattern / std::sqrt(variance)));
    const float edge = std::min(0.12f, 0.5f * std::min(cover, 1 - cover)) + 1e-4f;
    const float rafts = glm::smoothstep(-edge, edge, cover - even);
    return glm::mix(cover, rafts, std::clamp(variance / 0.008f, 0.0f, 1.0f));
}

} // namespace demos::reference
