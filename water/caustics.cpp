#include "water/caustics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "water/sea.h"

namespace seaglass {

namespace {

constexpr int octaves = 24;
constexpr double longest = 512; ///< of the waves told apart [m]

/// Variance of the surface's Laplacian, by octaves of wavelength from `longest` down [1/m^2].
std::array<double, octaves> curvatureVariance(const Sea& sea) {
    std::array<double, octaves> sums{};
    for (uint32_t c = 0; c < sea.count; ++c) {
        const Modes& modes = sea.modes[c];
        for (size_t at = 0; at < modes.inverseK.size(); ++at) {
            const auto inverseK = static_cast<double>(modes.inverseK[at]);
            if (!(inverseK > 0)) continue;
            const double wavelength = 2 * std::numbers::pi * inverseK;
            const auto octave = static_cast<int>(std::floor(std::log2(longest / wavelength)));
            const double k2 = 1 / (inverseK * inverseK);
            sums[static_cast<size_t>(std::clamp(octave, 0, octaves - 1))] += varianceAt(modes, at) * k2 * k2;
        }
    }
    return sums;
}

} // namespace

CausticBlur causticBlurOf(const Sea& sea) {
    // A slope turns the ray by a quarter of it, 1 - 1/n: at a depth h light has gathered by 1 +- h/4 of the
    // curvature. Half of that, as a deviation, is where rays begin to cross.
    constexpr double crosses = 0.5, turns = 0.25;
    const std::array<double, octaves> variance = curvatureVariance(sea);
    double sum = 0, count = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < octaves; ++i) {
        if (variance[static_cast<size_t>(i)] <= 0) continue;
        sum += variance[static_cast<size_t>(i)];
        const double depth = std::log2(crosses / (turns * std::sqrt(sum)));
        // A mean over a width lets half of the waves through that are 2.3 times as long.
        const double width = std::log2(std::ldexp(longest, -i - 1) / 2.3);
        if (depth < -6 || depth > 8) continue; // shallower and deeper than anybody looks
        count += 1;
        x += depth;
        y += width;
        xx += depth * depth;
        xy += depth * width;
    }
    CausticBlur blur;
    if (count < 1) return blur;
    const double spread = xx - x * x / count;
    blur.exponent = spread > 1e-6 ? (xy - x * y / count) / spread : 1.0;
    blur.log2Scale = (y - blur.exponent * x) / count;
    return blur;
}

} // namespace seaglass
