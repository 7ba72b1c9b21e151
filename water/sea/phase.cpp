#include "water/sea/phase.h"

#include <algorithm>
#include <cmath>

namespace seaglass {

uint32_t frequencyIndex(double omega, double loopPeriod) {
    const double turns = omega * loopPeriod / (2 * std::numbers::pi);
    return static_cast<uint32_t>(std::clamp(std::round(turns), 1.0, 4294967295.0));
}

uint32_t loopPhase(double time, double loopPeriod) {
    if (!std::isfinite(time)) return 0;
    const double turns = std::fmod(time, loopPeriod) / loopPeriod; // fmod does not round
    return static_cast<uint32_t>(std::llround(std::ldexp(turns, 32)));
}

} // namespace seaglass
