// Published values to lay beside a sea's.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "program/sea/sea_report.h"
#include "water/interface/whitecaps.h"

namespace demos {

namespace {

constexpr double g = 9.81;

/// Significant height and periods of Pierson and Moskowitz 1964, by the wind at 19.5 m.
void piersonMoskowitz(double wind, PublishedSea& out) {
    const double wind195 = 1.026 * wind;
    out.hsM = 0.21 * wind195 * wind195 / g;
    out.tpS = 2 * std::numbers::pi * wind195 / (0.877 * g);
    out.tzS = 0.710 * *out.tpS;
}

/// Hasselmann et al. 1973.
struct Jonswap {
    double alpha, peak, gamma;

    explicit Jonswap(const seaglass::SeaDesc& desc) : gamma(static_cast<double>(desc.peakEnhancement)) {
        const auto wind = static_cast<double>(desc.windSpeed);
        const double grown = g * static_cast<double>(desc.fetch) / (wind * wind);
        const double chi = desc.capFetch ? std::min(grown, 1e4) : grown;
        alpha = 0.076 * std::pow(chi, -0.22);
        peak = 22 * g / wind * std::pow(chi, -1.0 / 3);
    }
    double at(double omega) const {
        const double off = (omega - peak) / ((omega <= peak ? 0.07 : 0.09) * peak);
        return alpha * g * g * std::pow(omega, -5) * std::exp(-1.25 * std::pow(peak / omega, 4)) *
               std::pow(gamma, std::exp(-0.5 * off * off));
    }
};

/// What a bottom leaves of waves (Kitaigorodskii et al. 1975), by the wave number that bisection finds.
double shallow(double omega, double depthM) {
    const double deepKh = omega * omega / g * depthM;
    if (deepKh > 20) return 1;
    double low = 0, high = deepKh + 2;
    for (int i = 0; i < 60; ++i) {
        const double kh = 0.5 * (low + high);
        (kh * std::tanh(kh) < deepKh ? low : high) = kh;
    }
    return std::pow(std::tanh(high), 2) / (1 + 2 * high / std::sinh(2 * high));
}

/// JONSWAP's height, and TMA's (Bouws et al. 1985), which is the same over a bottom: their published
/// formula's integral. A bottom moves the peak by how much nobody says.
void grown(const seaglass::SeaDesc& desc, PublishedSea& out) {
    const Jonswap jonswap(desc);
    const bool tma = desc.spectrum == seaglass::SpectrumModel::tma;
    constexpr double ratio = 2e-3;
    double m0 = 0;
    for (double omega = 0.3 * jonswap.peak; omega < 100 * jonswap.peak; omega *= 1 + ratio)
        m0 += jonswap.at(omega) * (tma ? shallow(omega, static_cast<double>(desc.depth)) : 1) * omega * ratio;
    out.hsM = 4 * std::sqrt(m0);
    if (!tma) out.tpS = 2 * std::numbers::pi / jonswap.peak;
}

/// As a buoy reports the spectrum that it measured: 4 sqrt(m0) by the trapezoids between its rows, and the
/// period of the highest.
void buoy(const seaglass::SeaDesc& desc, PublishedSea& out) {
    const std::span rows(desc.spectrumTable, desc.spectrumTableCount);
    double m0 = 0;
    for (size_t i = 1; i < rows.size(); ++i)
        m0 += 0.5 * (static_cast<double>(rows[i].density) + static_cast<double>(rows[i - 1].density)) *
              (static_cast<double>(rows[i].frequency) - static_cast<double>(rows[i - 1].frequency));
    const auto highest = std::ranges::max_element(rows, {}, &seaglass::SpectrumSample::density);
    out.hsM = 4 * std::sqrt(m0);
    out.tpS = 1 / static_cast<double>(highest->frequency);
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
        return out;
    }
    if (!(wind > 0)) return out;
    switch (desc.spectrum) {
    case seaglass::SpectrumModel::piersonMoskowitz:
        piersonMoskowitz(wind, out);
        break;
    case seaglass::SpectrumModel::jonswap:
    case seaglass::SpectrumModel::tma:
        grown(desc, out);
        break;
    case seaglass::SpectrumModel::table:
        buoy(desc, out);
        break;
    default: // a shape, published without a height
        break;
    }
    return out;
}

} // namespace demos
