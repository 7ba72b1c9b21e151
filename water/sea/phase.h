// Phases that stay exact however late it is. Frequencies are whole multiples n of 2 pi / T, T the time after
// which the sea repeats, and the phase is the wrapped 32-bit product n * round(2^32 frac(t/T)): no rounding
// grows with time, and every device forms the same integer.
#pragma once

#include <cstdint>
#include <numbers>

namespace seaglass {

/// n: the multiple of 2 pi / loopPeriod nearest to omega, at least 1.
uint32_t frequencyIndex(double omega, double loopPeriod);

/// round(2^32 frac(time / loopPeriod)), wrapped; any finite time, negative and huge ones included. 0 for the
/// others.
uint32_t loopPhase(double time, double loopPeriod);

constexpr uint32_t wavePhase(uint32_t frequencyIndex, uint32_t loopPhase) {
    return frequencyIndex * loopPhase;
}

/// A phase in radians, in [-pi, pi).
constexpr double radians(uint32_t phase) {
    return static_cast<double>(static_cast<int32_t>(phase)) * (2 * std::numbers::pi / 4294967296.0);
}

struct SineCosine {
    float sine;
    float cosine;
};

/// Within 1.3e-7 of the exact values. Branch-free, so that loops over it vectorise.
inline SineCosine sineCosine(uint32_t phase) {
    // The nearest quarter turn is taken off as an integer, which is exact; in [-pi/4, pi/4] short series do.
    const uint32_t quarter = (phase + 0x20000000u) & 0xc0000000u;
    const float x = static_cast<float>(static_cast<int32_t>(phase - quarter)) *
                    (2 * std::numbers::pi_v<float> / 4294967296.0f);
    const float x2 = x * x;
    const float sine = x + x * x2 * (-1.6666654611e-1f + x2 * (8.3321608736e-3f - x2 * 1.9515295891e-4f));
    const float cosine =
        1.0f - 0.5f * x2 +
        x2 * x2 * (4.166664568298827e-2f + x2 * (-1.388731625493765e-3f + x2 * 2.443315711809948e-5f));
    const bool odd = (quarter & 0x40000000u) != 0;
    const float sineSign = (quarter & 0x80000000u) != 0 ? -1.0f : 1.0f;
    const float cosineSign = ((quarter + 0x40000000u) & 0x80000000u) != 0 ? -1.0f : 1.0f;
    return {sineSign * (odd ? cosine : sine), cosineSign * (odd ? sine : cosine)};
}

} // namespace seaglass
