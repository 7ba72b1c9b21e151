#include "water/cascades.h"

#include <algorithm>
#include <numbers>

namespace seaglass {
namespace {

// The square of the silver ratio 1 + sqrt(2), far from every simple fraction: tiles of two cascades line up
// nowhere near.
constexpr double patchRatio = 3 + 2 * std::numbers::sqrt2;

// The longest waves on a tile fit this often on it; with fewer, their repetition shows. A circle of this
// radius holds as many lattice points as its area, 213: at 8.0, say, it holds 193 for 201, and the cascade is
// 4 % too energetic.
constexpr double wavesPerTile = 8.234;
constexpr double peakWavesPerLargestTile = 16;

constexpr double samplesPerWave = 4;

// Viscosity leaves no wind waves shorter than a millimetre.
constexpr double largestWaveNumber = 2 * std::numbers::pi / 1e-3;

} // namespace

void layCascades(const SeaDesc& desc, const Spectrum& spectrum, Cascade* cascades) {
    double patch = desc.largestPatch > 0
                       ? static_cast<double>(desc.largestPatch)
                       : std::clamp(peakWavesPerLargestTile * peakWavelength(spectrum), 60.0, 2000.0);
    double kMin = 0;
    for (uint32_t c = 0; c < desc.cascades; ++c) {
        const double dk = 2 * std::numbers::pi / patch;
        const double resolved = dk * desc.samples / samplesPerWave;
        const double handedOver = dk * patchRatio * wavesPerTile;
        const bool last = c + 1 == desc.cascades;
        const double wanted = last ? resolved : std::min(resolved, handedOver);
        const double kMax = std::max(std::min(wanted, largestWaveNumber), kMin);
        cascades[c] = {.patch = patch, .samples = desc.samples, .kMin = kMin, .kMax = kMax, .variance = 0};
        kMin = kMax;
        patch /= patchRatio;
    }
}

} // namespace seaglass
