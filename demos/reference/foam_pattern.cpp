#include "reference/foam_pattern.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Not public: the pattern is the library's own, and there is to be but one.
#include "water/foam.h"
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

/// One octave of the pattern, and its mean where the pixel is too wide to show it.
float patternOctave(const glm::dvec2& calm, double tile, float pixelWidth) {
    const float texels = pixelWidth * static_cast<float>(seaglass::foamPatternSamples / tile);
    const float blur = std::clamp(0.5f * std::log2(std::max(texels, 1.0f)), 0.0f, 1.0f);
    return glm::mix(patternAt(calm, tile), 0.5f, blur);
}

} // namespace

float foamMask(const glm::dvec2& calm, float pixelWidth, float cover) {
    constexpr double tile = seaglass::foamTile;
    const float pattern = 0.45f * patternOctave(calm, tile, pixelWidth) +
                          0.3f * patternOctave(calm, tile / 4, pixelWidth) +
                          0.25f * patternOctave(calm, tile / 16, pixelWidth);
    const float rafts = glm::smoothstep(-0.06f, 0.10f, cover - pattern);
    return glm::mix(rafts, cover, std::clamp(std::log2(std::max(pixelWidth, 1e-6f) / 0.3f) / 4, 0.0f, 1.0f));
}

} // namespace demos::reference
