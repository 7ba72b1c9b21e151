// What the waves add to the surface's slopes, resolved or not.
#include "water/sea.h"

#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

// Waves of 17 mm travel slowest and mark the end of the gravity range, which the spectra describe.
constexpr double shortestGravityWave = 365.0; // [rad/m]
constexpr int steps = 256;

// The integral of k^2 S(k) dk, by the midpoint rule over equal ratios of k.
double slopeVariance(const WaveSystems& systems, double kMin, double kMax) {
    const double ratio = std::log(kMax / kMin) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double k = kMin * std::exp((i + 0.5) * ratio);
        sum += k * k * waveNumberSpectrum(systems, k) * k * ratio;
    }
    return sum;
}

double scaledVariance(const Sea& sea, double kMin, double kMax) {
    const auto amplitude = static_cast<double>(sea.desc.amplitude);
    return amplitude * amplitude * slopeVariance(sea.systems, kMin, kMax);
}

double shortestResolved(const Sea& sea) {
    return sea.cascades[sea.count - 1].kMax;
}

} // namespace

double resolvedSlopeVariance(const Sea& sea) {
    if (sea.count == 0) return 0;
    // The first cascade begins at its lattice's first wave; what is longer has next to no slope.
    const double longest = 2 * std::numbers::pi / sea.cascades[0].patch;
    return scaledVariance(sea, longest, shortestResolved(sea));
}

double unresolvedSlopeVariance(const Sea& sea) {
    if (sea.count == 0 || shortestResolved(sea) >= shortestGravityWave) return 0;
    return scaledVariance(sea, shortestResolved(sea), shortestGravityWave);
}

} // namespace seaglass
