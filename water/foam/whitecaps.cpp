#include "water/interface/whitecaps.h"

#include "water/sea/sea.h"
#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

// Waves of 10 m and more, and down to a twelfth of the peak's, make the whitecaps that are seen; shorter ones
// break without much foam.
double shortestBreaker(const Sea& sea) {
    return std::max(12 * sea.peak * sea.peak / gravity, 2 * std::numbers::pi / 10);
}

// Below how many deviations of its Jacobian a cascade breaks. Foam is rarer in less wind though waves are
// about as steep: fitted, for what foam_gate.h shows of the first one, to the geometric mean of the two laws
// at 8 to 20 m/s (docs/physics.md).
double deviationsToBreak(double wind, uint32_t cascade) {
    return cascade == 0 ? 5.735 - 1.32 * std::log(wind) : 5.53 - 1.09 * std::log(wind);
}

// Of the Jacobian of one cascade at full amplitude and choppiness 1: to first order 1 + div D, whose variance
// is that of the slope. Calmer water than the wind's own keeps the threshold and so foams less.
double jacobianDeviation(const Sea& sea, uint32_t cascade) {
    const Modes& modes = sea.modes[cascade];
    double variance = 0;
    for (size_t i = 0; i < modes.inverseK.size(); ++i) {
        if (modes.inverseK[i] == 0) continue;
        const auto sum = [](double re, double im) { return re * re + im * im; };
        const double k = 1 / static_cast<double>(modes.inverseK[i]);
        variance += 2 * k * k *
                    (sum(static_cast<double>(modes.forwardRe[i]), static_cast<double>(modes.forwardIm[i])) +
                     sum(static_cast<double>(modes.backwardRe[i]), static_cast<double>(modes.backwardIm[i])));
    }
    return std::sqrt(variance) / static_cast<double>(sea.desc.amplitude);
}

Breaking breakingInTheOpen(const Sea& sea, const FoamDesc& foam) {
    Breaking breaking;
    constexpr double leastWind = 2; // [m/s]; either law leaves less than 5e-5 here
    constexpr double never = 7;     // deviations: no sample of a loop's whole time
    const auto wind = static_cast<double>(sea.desc.windSpeed);
    if (wind < leastWind) return breaking;
    const double drawn = double{sea.desc.amplitude} * double{sea.desc.choppiness};
    const double shortest = shortestBreaker(sea);
    for (uint32_t c = 0; c < sea.count && sea.cascades[c].kMin < shortest; ++c) {
        const double deviation = jacobianDeviation(sea, c);
        breaking.threshold[c] = foam.bias + static_cast<float>(1 - deviationsToBreak(wind, c) * deviation);
        breaking.softness[c] = static_cast<float>(0.1 * deviation);
        if (1 - never * drawn * deviation < double{breaking.threshold[c]}) breaking.count = c + 1;
    }
    return breaking;
}

} // namespace

Breaking breakingOf(const Sea& sea, const FoamDesc& foam) {
    Breaking breaking;
    if (sea.count == 0) return breaking;
    breaking = breakingInTheOpen(sea, foam);
    if (breaking.count == 0 && sea.shore) {
        // A history is kept, in which nothing happens.
        breaking.threshold[0] = -1e6f;
        breaking.softness[0] = 1;
        breaking.count = 1;
    }
    return breaking;
}

double whitecapsOfMonahan(double windSpeed) {
    return 3.84e-6 * std::pow(std::max(windSpeed, 0.0), 3.41);
}

double whitecapsOfCallaghan(double windSpeed) {
    const auto cubed = [](double x) { return x * x * x; };
    // The two fits overlap from 9.25 to 11.25 m/s, and cross here.
    constexpr double crossing = 10.187;
    if (windSpeed < crossing) return 3.18e-5 * cubed(std::max(windSpeed - 3.70, 0.0));
    return 4.82e-6 * cubed(windSpeed + 1.98);
}

} // namespace seaglass
