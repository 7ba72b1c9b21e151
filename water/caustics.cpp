#include "water/caustics.h"

#include <array>
#include <cmath>

#include "water/wave_octaves.h"

namespace seaglass {

CausticBlur causticBlurOf(const Sea& sea) {
    // A slope turns the ray by a quarter of it, 1 - 1/n: at a depth h light has gathered by 1 +- h/4 of the
    // curvature. Half of that, as a deviation, is where rays begin to cross.
    constexpr double crosses = 0.5, turns = 0.25;
    const std::array<double, waveOctaves> variance = varianceByOctave(sea, 2); // of the surface's Laplacian
    double sum = 0, count = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < waveOctaves; ++i) {
        if (variance[static_cast<size_t>(i)] <= 0) continue;
        sum += variance[static_cast<size_t>(i)];
        const double depth = std::log2(crosses / (turns * std::sqrt(sum)));
        // A mean over a width lets half of the waves through that are 2.3 times as long.
        const double width = std::log2(std::ldexp(longestOctave, -i - 1) / 2.3);
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
