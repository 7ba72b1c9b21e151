#include "water/spectrum/slope_variance.h"

#include "water/sea/sea.h"
#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

// Waves of 17 mm travel slowest and mark the end of the gravity range, which the spectra describe.
constexpr double shortestGravityWave = 365.0; // [rad/m]

struct CoxMunk {
    double upwind = 0;
    double crosswind = 0;
};

// Cox and Munk 1954, clean sea. Their wind is at 12.5 m; the logarithmic profile that puts 1.026 U10 at 19.5
// m has 1.0087 U10 there. They saw 1 to 14 m/s: in less the crosswind's 0.003 goes with the wind, as water
// turns to glass; past 30 m/s nothing is added.
CoxMunk coxMunk(double windSpeed) {
    const double wind = 1.0087 * std::min(windSpeed, 30.0);
    return {3.16e-3 * wind, 0.003 * std::min(wind, 1.0) + 1.92e-3 * wind};
}

// The integral of k^2 S(k) (k / kMin)^-decay dk, by the midpoint rule over equal ratios of k.
double slopeVariance(const WaveSystems& systems, double kMin, double kMax, double decay = 0) {
    constexpr int steps = 256;
    const double ratio = std::log(kMax / kMin) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double k = kMin * std::exp((i + 0.5) * ratio);
        sum += k * k * waveNumberSpectrum(systems, k) * std::pow(k / kMin, -decay) * k * ratio;
    }
    return sum;
}

// From here the waves may be lowered: they hold a hundredth of the height's variance.
double firstShortWave(const Sea& sea) {
    const double wind = std::max(static_cast<double>(sea.desc.windSpeed), 0.1);
    return 10 * std::max(gravity / (wind * wind), sea.peak * sea.peak / gravity);
}

// By which power of k waves are lowered, 0..8.
double decayOf(const Sea& sea, double first) {
    const CoxMunk budget = coxMunk(static_cast<double>(sea.desc.windSpeed));
    const double room = budget.upwind + budget.crosswind - slopeVariance(sea.systems, first * 1e-3, first);
    if (slopeVariance(sea.systems, first, shortestGravityWave) <= room) return 0;
    double low = 0, high = 8;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        const bool fits = slopeVariance(sea.systems, first, shortestGravityWave, middle) <= room;
        (fits ? high : low) = middle;
    }
    return high;
}

void lower(Modes& modes, Cascade& cascade, double first, double decay) {
    for (size_t at = 0; at < modes.inverseK.size(); ++at) {
        const double beyond = first * static_cast<double>(modes.inverseK[at]);
        if (beyond == 0 || beyond >= 1) continue;
        cascade.variance -= varianceAt(modes, at);
        const auto share = static_cast<float>(std::pow(beyond, 0.5 * decay));
        for (auto* values : {&modes.forwardRe, &modes.forwardIm, &modes.backwardRe, &modes.backwardIm})
            (*values)[at] *= share;
        cascade.variance += varianceAt(modes, at);
    }
}

} // namespace

void limitSlopes(Sea& sea) {
    const double first = firstShortWave(sea);
    if (first >= shortestGravityWave) return;
    const double decay = decayOf(sea, first);
    if (decay == 0) return;
    for (uint32_t c = 0; c < sea.count; ++c) lower(sea.modes[c], sea.cascades[c], first, decay);
}

SlopeCovariance slopesOf(const Sea& sea) {
    SlopeCovariance sum;
    for (uint32_t c = 0; c < sea.count; ++c) {
        const Modes& modes = sea.modes[c];
        const double dk = 2 * std::numbers::pi / sea.cascades[c].patch;
        for (int32_t n = 0; n <= modes.reach; ++n)
            for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
                const double variance = varianceAt(modes, modes.at(m, n)) * dk * dk;
                sum.uu += variance * m * m;
                sum.vv += variance * n * n;
                sum.uv += variance * m * n;
            }
    }
    return sum;
}

SlopeCovariance roughnessOf(const Sea& sea, const SlopeCovariance& resolved) {
    const auto wind = static_cast<double>(sea.desc.windSpeed),
               amplitude = static_cast<double>(sea.desc.amplitude);
    const double alongU = std::cos(static_cast<double>(sea.desc.windDirection));
    const double alongV = std::sin(static_cast<double>(sea.desc.windDirection));
    const double resolvedUpwind =
        alongU * alongU * resolved.uu + alongV * alongV * resolved.vv + 2 * alongU * alongV * resolved.uv;
    const CoxMunk budget = coxMunk(wind);
    const double scale = amplitude * amplitude;
    const double total =
        std::max(scale * (budget.upwind + budget.crosswind) - resolved.uu - resolved.vv, 0.0);
    // Ripples run every way: neither axis is left without.
    const double upwind = std::clamp(scale * budget.upwind - resolvedUpwind, 0.25 * total, 0.75 * total);
    const double crosswind = total - upwind;
    return {upwind * alongU * alongU + crosswind * alongV * alongV,
            upwind * alongV * alongV + crosswind * alongU * alongU, (upwind - crosswind) * alongU * alongV};
}

double coxMunkSlopeVariance(double windSpeed) {
    const CoxMunk slopes = coxMunk(windSpeed);
    return slopes.upwind + slopes.crosswind;
}

SlopeCovariance resolvedSlopes(const Sea& sea) {
    return sea.slopes;
}
SlopeCovariance roughness(const Sea& sea) {
    return sea.roughness;
}
double resolvedSlopeVariance(const Sea& sea) {
    return sea.slopes.uu + sea.slopes.vv;
}
double unresolvedSlopeVariance(const Sea& sea) {
    return sea.roughness.uu + sea.roughness.vv;
}

} // namespace seaglass
