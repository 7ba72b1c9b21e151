#include "water/spectrum.h"

#include "water/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

Spectrum piersonMoskowitz(double wind) {
    // The published constants are for the wind at 19.5 m: S = 8.1e-3 g^2 w^-5 exp(-0.74 (g/(U w))^4).
    const double wind195 = 1.026 * wind;
    const double peakOfWind = std::pow(0.8 * 0.74, 0.25);
    return {.alpha = 8.1e-3, .peak = peakOfWind * gravity / wind195, .gamma = 1, .wind = wind};
}

Spectrum jonswap(double wind, double fetch, bool capFetch, double gamma) {
    constexpr double fullyDeveloped = 1e4;
    const double chi = gravity * fetch / (wind * wind);
    const double x = capFetch ? std::min(chi, fullyDeveloped) : chi;
    return {.alpha = 0.076 * std::pow(x, -0.22),
            .peak = 22 * gravity / wind * std::pow(x, -1.0 / 3),
            .gamma = gamma,
            .wind = wind};
}

} // namespace

Spectrum makeSpectrum(const SeaDesc& desc) {
    if (desc.spectrum == SpectrumModel::piersonMoskowitz) return piersonMoskowitz(desc.windSpeed);
    return jonswap(desc.windSpeed, desc.fetch, desc.capFetch, desc.peakEnhancement);
}

double energy(const Spectrum& spectrum, double omega) {
    if (!(omega > 0)) return 0;
    const double ratio = spectrum.peak / omega;
    const double exponent = 1.25 * ratio * ratio * ratio * ratio;
    // Far below the peak w^-5 overflows where the exponential has long vanished.
    if (exponent > 700) return 0;
    const double sigma = omega <= spectrum.peak ? 0.07 : 0.09;
    const double off = (omega - spectrum.peak) / (sigma * spectrum.peak);
    const double enhancement = std::pow(spectrum.gamma, std::exp(-0.5 * off * off));
    return spectrum.alpha * gravity * gravity * std::pow(omega, -5) * std::exp(-exponent) * enhancement;
}

double peakWavelength(const Spectrum& spectrum) {
    return 2 * std::numbers::pi * gravity / (spectrum.peak * spectrum.peak);
}

} // namespace seaglass
