#include "reference/light/foam_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/shade/optics.h"

#include "water/interface/foam_texels.h"

namespace demos::reference {
namespace {

constexpr double tileM = 24, repeat = WaterSurface::laceRepeatM; // [m]

using Mips = std::vector<std::vector<seaglass::FoamTexel>>;

/// Pattern, bend and slopes, each -0.5..0.5.
glm::vec4 bilinear(const Mips& mips, size_t mip, const glm::dvec2& place) {
    const auto size = int64_t(seaglass::foamPatternSamples >> mip);
    const double x = (place.x - std::floor(place.x)) * static_cast<double>(size) - 0.5;
    const double y = (place.y - std::floor(place.y)) * static_cast<double>(size) - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto at = [&](double i, double j) {
        const auto column = static_cast<size_t>((static_cast<int64_t>(i) + size) % size);
        const auto row = static_cast<size_t>((static_cast<int64_t>(j) + size) % size);
        const seaglass::FoamTexel& t = mips[mip][row * static_cast<size_t>(size) + column];
        return glm::vec4(t.pattern, t.bend, t.slopeU, t.slopeV) / 255.0f - 0.5f;
    };
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    return glm::mix(glm::mix(at(x0, y0), at(x0 + 1, y0), fx),
                    glm::mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
}

glm::vec4 texelAt(const glm::dvec2& place, float texels) {
    static const Mips mips = seaglass::foamPattern();
    const float mip = std::min(std::log2(texels), static_cast<float>(mips.size() - 1));
    const auto finer = static_cast<size_t>(mip);
    const float share = mip - static_cast<float>(finer);
    const glm::vec4 found = bilinear(mips, finer, place);
    return share > 0 ? glm::mix(found, bilinear(mips, finer + 1, place), share) : found;
}

struct Part {
    glm::dvec2 here, beside;
    float share;
};

/// foamPartOf() of the shader.
Part partOf(const glm::dvec2& place) {
    const glm::dvec2 turn = 2 * std::numbers::pi / repeat * place;
    const double index =
        4 + 1.1 * (std::sin(7 * turn.x + 3 * turn.y) + std::sin(9 * turn.y - 5 * turn.x + 1) +
                   std::sin(11 * turn.x - 4 * turn.y + 2));
    const glm::dvec2 spread = tileM * glm::dvec2(0.7548777, 0.5698403);
    const double part = std::floor(index + 0.5), off = index - part;
    return {place + part * spread, place + (part + (off < 0 ? -1 : 1)) * spread,
            static_cast<float>(0.5 * glm::smoothstep(0.38, 0.5, std::abs(off)))};
}

glm::vec4 patternAt(const Part& part, double tile, float texels) {
    const glm::vec4 texel = texelAt(part.here / tile, texels);
    if (part.share <= 0) return texel;
    return glm::mix(texel, texelAt(part.beside / tile, texels), part.share) /
           glm::length(glm::vec2(part.share, 1 - part.share));
}

/// Share of the places where a sum of three even distributions, of these widths and of mean 0, is below `x`.
float shareBelow(float x, const glm::vec3& widths) {
    const float t = std::max(0.5f * (widths.x + widths.y + widths.z) - std::abs(x), 0.0f);
    const glm::vec3 one = glm::max(t - widths, 0.0f);
    const glm::vec3 two = glm::max(t - widths - glm::vec3(widths.y, widths.z, widths.x), 0.0f);
    const float tail = (t * t * t - glm::dot(one * one, one) + glm::dot(two * two, two)) /
                       (6 * widths.x * widths.y * widths.z);
    return x < 0 ? tail : 1 - tail;
}

} // namespace

Foam foamAt(const WaterSurface& surface, const glm::dvec2& calm, float pixelWidth) {
    constexpr std::array weights = {0.33f, 0.39f, 0.28f}; // of windrows, rafts and lace
    constexpr std::array tiles = {WaterSurface::windrowTileM, tileM, tileM / 7};
    const glm::dvec2 carried = calm - surface.edge(calm, static_cast<double>(pixelWidth)).advected;
    const Part part = partOf(surface.onLace(carried));
    const glm::dvec2 windrows = surface.onWindrows(surface.onWaves(carried, calm));
    constexpr float patternVariance = (0.33f * 0.33f + 0.39f * 0.39f + 0.28f * 0.28f) / 12, softEdges = 0.2f;
    float pattern = 0, variance = 0;
    glm::vec3 widths;
    std::array<float, 3> bend;
    Foam foam;
    for (size_t i = 0; i < 3; ++i) {
        const float texels = std::max(
            pixelWidth * static_cast<float>(seaglass::foamPatternSamples / tiles[i]), i == 0 ? 4.0f : 1.0f);
        const glm::vec4 texel =
            i == 0 ? texelAt(windrows / tiles[0], texels) : patternAt(part, tiles[i], texels);
        const float last = std::clamp(8 - std::log2(texels), 0.0f, 1.0f);
        const float kept = weights[i] * last * last * 30 / (29.15f + texels);
        pattern += weights[i] * last * texel.x;
        variance += kept * kept / 12;
        widths[static_cast<int>(i)] = kept;
        foam.slope += glm::vec2(texel.z, texel.w);
        bend[i] = 2 * texel.y;
        if (i == 0) foam.plume = 1 - 1.2f * last * texel.x;
    }
    const glm::dvec2 bent(bend[0] + 0.4f * bend[2], bend[1] - 0.4f * bend[2]);
    const auto [cover, plume] = surface.foamCover(calm, bent, static_cast<double>(pixelWidth));
    widths = glm::max(widths, 0.15f * (widths.x + widths.y + widths.z) + 1e-3f);
    const float even = std::clamp(shareBelow(pattern, widths), 2e-4f, 1 - 2e-4f);
    const float kept2 = (1 - softEdges) * variance / patternVariance;
    foam.mask = gaussianBelow((gaussianQuantile(cover) - std::sqrt(kept2) * gaussianQuantile(even)) /
                              std::sqrt(1 - kept2));
    foam.fresh = cover;
    foam.plume = std::min(foam.plume * plume, 1.0f);
    foam.height = kept2 * kept2 * std::clamp(1 - 2 * even / std::max(cover, 1e-3f), -1.0f, 1.0f);
    return foam;
}

} // namespace demos::reference
