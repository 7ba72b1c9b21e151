#include "water/waves/wave_fields.h"

#include <cmath>

namespace seaglass {

float wavePacking(const Modes& modes) {
    double heights = 0, slopes = 0;
    for (size_t at = 0; at < modes.frequency.size(); ++at) {
        if (modes.frequency[at] == 0) continue;
        const auto square = [](float x) { return static_cast<double>(x) * static_cast<double>(x); };
        const double energy = square(modes.forwardRe[at]) + square(modes.forwardIm[at]) +
                              square(modes.backwardRe[at]) + square(modes.backwardIm[at]);
        heights += energy;
        slopes += energy / square(modes.inverseK[at]);
    }
    if (!(heights > 0 && slopes > 0)) return 1;
    return std::exp2(static_cast<float>(std::round(0.5 * std::log2(heights / slopes))));
}

} // namespace seaglass
