#include "water/spray/spume.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "water/interface/whitecaps.h"
#include "water/sea/smoothstep.h"

namespace seaglass {

namespace {

/// Number of drops a square metre, second and micrometre of radius at 80 % humidity, of 10 um (Smith, Park
/// and Consterdine 1993).
double smallestDrops(double windSpeed) {
    const double at14 = 1.03 * windSpeed;
    const auto bell = [](double logStrength, double form, double radius) {
        const double away = std::log(10 / radius);
        return std::pow(10, logStrength) * std::exp(-form * away * away);
    };
    return bell(0.0676 * at14 + 2.43, 3.1, 2.1) + bell(0.959 * std::sqrt(at14) - 1.476, 3.3, 9.2);
}

/// Integral of r^power over a range.
double integral(double power, double from, double to) {
    const double p = power + 1;
    return (std::pow(to, p) - std::pow(from, p)) / p;
}

} // namespace

double spumeFlux(double windSpeed) {
    if (!(windSpeed > leastSpumeWind)) return 0;
    // Andreas 1998, (3.5): falls by r^-1, r^-2.8, r^-8, each beginning where the one before ends.
    const double first = 3.5 * smallestDrops(windSpeed) * 10;
    const double second = first * std::pow(37.5, 2.8 - 1);
    const double third = second * std::pow(100, 8 - 2.8);
    const double squareMicrometres = first * integral(2 - 1, 10, 37.5) +
                                     second * integral(2 - 2.8, 37.5, 100) +
                                     third * integral(2 - 8, 100, 500);
    return std::numbers::pi * squareMicrometres * 1e-12;
}

double tornShare(double windSpeed) {
    constexpr double spindrift = 19, whole = 31; // Beaufort 8 and 11, mean winds [m/s]
    if (!(windSpeed > leastSpumeWind)) return 0;
    const auto perWhitecap = [](double wind) { return spumeFlux(wind) / whitecapsOfMonahan(wind); };
    const double share = perWhitecap(std::min(windSpeed, whole)) / perWhitecap(whole);
    return std::min(share * smoothstep(leastSpumeWind, spindrift, windSpeed), 1.0);
}

} // namespace seaglass
