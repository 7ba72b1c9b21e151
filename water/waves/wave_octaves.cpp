#include "water/waves/wave_octaves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "water/sea/sea.h"

namespace seaglass {

int octaveOf(double wavelength) {
    return std::clamp(static_cast<int>(std::floor(std::log2(longestOctave / wavelength))), 0,
                      waveOctaves - 1);
}

std::array<double, waveOctaves> varianceByOctave(const Sea& sea, int power) {
    std::array<double, waveOctaves> sums{};
    for (uint32_t c = 0; c < sea.count; ++c) {
        const Modes& modes = sea.modes[c];
        for (size_t at = 0; at < modes.inverseK.size(); ++at) {
            const auto inverseK = static_cast<double>(modes.inverseK[at]);
            if (!(inverseK > 0)) continue;
            const int octave = octaveOf(2 * std::numbers::pi * inverseK);
            sums[static_cast<size_t>(octave)] += varianceAt(modes, at) * std::pow(inverseK, -2 * power);
        }
    }
    return sums;
}

} // namespace seaglass
