#include "water/sea/cascades.h"

#include <algorithm>
#include <cmath>
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
// However long the waves: with fewer, the lattice is too coarse for a spectrum's peak.
constexpr double leastPeakWavesPerTile = 6;

// The last band ends so far past the dominant peak at the least, about half of its energy below.
constexpr double pastPeak = 1.4;

constexpr double samplesPerWave = 4;

// Nothing shorter than these capillary waves has a peak to hold.
constexpr double smallestPatch = 0.05;

// Viscosity leaves no wind waves shorter than a millimetre.
constexpr double largestWaveNumber = 2 * std::numbers::pi / 1e-3;

double automaticPatch(const SeaDesc& desc, const WaveSystems& systems) {
    double longest = 0;
    for (uint32_t i = 0; i < systems.count; ++i)
        longest = std::max(longest, peakWavelength(systems.system[i].spectrum, systems.depth));
    const double dominant = peakWavelength(dominantSystem(systems).spectrum, systems.depth);
    const double wanted = std::max(std::clamp(peakWavesPerLargestTile * longest, 60.0, 2000.0),
                                   leastPeakWavesPerTile * longest);
    // The last cascade ends at samplesPerWave of its samples.
    const double wavesPerTile = desc.samples / samplesPerWave * std::pow(patchRatio, desc.cascades - 1.0);
    return std::max(std::min(wanted, wavesPerTile / pastPeak * dominant), smallestPatch);
}

} // namespace

void layCascades(const SeaDesc& desc, const WaveSystems& systems, Cascade* cascades) {
    double patch =
        desc.largestPatch > 0 ? static_cast<double>(desc.largestPatch) : automaticPatch(desc, systems);
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
