// Published values to lay beside a sea's.
#include <array>
#include <cmath>
#include <numbers>

#include "program/sea_report.h"
#include "seaglass/foam.h"

namespace demos {

namespace {

constexpr double g = 9.81;
constexpr double tau = 2 * std::numbers::pi;

/// Significant height and periods of Pierson and Moskowitz 1964, by the wind at 19.5 m.
void piersonMoskowitz(double wind, PublishedSea& out) {
    const double wind195 = 1.026 * wind;
    out.hsM = 0.21 * wind195 * wind195 / g;
    out.tpS = tau * wind195 / (0.877 * g);
    out.tzS = 0.710 * *out.tpS;
}

/// Of Hasselmann et al. 1973, gamma 3.3, whose peak has 1.525 times the energy of none.
void jonswap(const seaglass::SeaDesc& desc, PublishedSea& out) {
    const auto wind = static_cast<double>(desc.windSpeed);
    const double grown = g * static_cast<double>(desc.fetch) / (wind * wind);
    const double chi = desc.capFetch ? std::min(grown, 1e4) : grown;
    const double alpha = 0.076 * std::pow(chi, -0.22);
    const double peak = 22 * g / wind * std::pow(chi, -1.0 / 3);
    out.hsM = 4 * std::sqrt(1.525 * alpha / 5) * g / (peak * peak);
    out.tpS = tau / peak;
}

/// Probable heights of the open sea, World Meteorological Organization.
constexpr std::array<double, 13> beaufortHeights = {0, 0.1, 0.2, 0.6, 1, 2, 3, 4, 5.5, 7, 9, 11.5, 14};

} // namespace

PublishedSea publishedFor(const seaglass::SeaDesc& desc, const WavesDesc& waves) {
    PublishedSea out;
    const auto wind = static_cast<double>(desc.windSpeed);
    out.slopeVariance = 0.003 + 5.12e-3 * wind;
    out.whitecapsOfMonahan = seaglass::whitecapsOfMonahan(wind);
    out.whitecapsOfCallaghan = seaglass::whitecapsOfCallaghan(wind);
    if (waves.beaufort != WavesDesc::noForce) {
        out.hsM = beaufortHeights[waves.beaufort];
    } else if (wind > 0 && desc.spectrum == seaglass::SpectrumModel::piersonMoskowitz) {
        piersonMoskowitz(wind, out);
    } else if (wind > 0 && desc.spectrum == seaglass::SpectrumModel::jonswap &&
               desc.peakEnhancement == 3.3f) {
        jonswap(desc, out);
    }
    return out;
}

} // namespace demos
