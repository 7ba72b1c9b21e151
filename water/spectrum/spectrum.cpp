#include "water/spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

constexpr double tau = 2 * std::numbers::pi;

// Of the saturated range of a fully developed sea.
constexpr double phillipsConstant = 8.1e-3;

Spectrum fullyDeveloped(double exponent, double windOfExponent, double wind) {
    // S = 8.1e-3 g^2 w^-5 exp(-exponent (g/(U w))^4), whose peak has an exponent of 5/4.
    const double peakOfWind = std::pow(0.8 * exponent, 0.25);
    return {.peak = peakOfWind * gravity / windOfExponent, .wind = wind, .alpha = phillipsConstant};
}

Spectrum piersonMoskowitz(double wind) {
    // The published constants are for the wind at 19.5 m.
    return fullyDeveloped(0.74, 1.026 * wind, wind);
}

Spectrum phillips(double wind) {
    // In deep water k = w^2/g, so that (k L)^-2 = (g/(U w))^4.
    return fullyDeveloped(1, wind, wind);
}

Spectrum jonswap(const SeaDesc& desc) {
    constexpr double longestFetch = 1e4;
    const double wind = desc.windSpeed;
    const double chi = gravity * static_cast<double>(desc.fetch) / (wind * wind);
    const double x = desc.capFetch ? std::min(chi, longestFetch) : chi;
    return {.peak = 22 * gravity / wind * std::pow(x, -1.0 / 3),
            .wind = wind,
            .alpha = 0.076 * std::pow(x, -0.22),
            .gamma = desc.peakEnhancement};
}

Spectrum tma(const SeaDesc& desc) {
    Spectrum spectrum = jonswap(desc);
    spectrum.depth = desc.depth;
    return spectrum;
}

Spectrum tabulated(const SeaDesc& desc) {
    const std::span table(desc.spectrumTable, desc.spectrumTableCount);
    const auto highest =
        std::max_element(table.begin(), table.end(), [](const SpectrumSample& a, const SpectrumSample& b) {
            return a.density < b.density;
        });
    return {.form = Spectrum::Form::table,
            .peak = tau * static_cast<double>(highest->frequency),
            .wind = desc.windSpeed,
            .table = table};
}

double windSeaEnergy(const Spectrum& spectrum, double omega) {
    const double ratio = spectrum.peak / omega;
    const double exponent = 1.25 * ratio * ratio * ratio * ratio;
    // Far below the peak w^-5 overflows where the exponential has long vanished.
    if (exponent > 700) return 0;
    const double sigma = omega <= spectrum.peak ? 0.07 : 0.09;
    const double off = (omega - spectrum.peak) / (sigma * spectrum.peak);
    const double enhancement = std::pow(spectrum.gamma, std::exp(-0.5 * off * off));
    return spectrum.alpha * gravity * gravity * std::pow(omega, -5) * std::exp(-exponent) * enhancement *
           kitaigorodskii(omega, spectrum.depth);
}

double swellEnergy(const Spectrum& spectrum, double omega) {
    const double width = spectrum.bandwidth * spectrum.peak;
    const double off = (omega - spectrum.peak) / width;
    return spectrum.variance / (width * std::sqrt(tau)) * std::exp(-0.5 * off * off);
}

double tableEnergy(std::span<const SpectrumSample> table, double omega) {
    const double frequency = omega / tau;
    const auto above =
        std::upper_bound(table.begin(), table.end(), frequency, [](double f, const SpectrumSample& sample) {
            return f < static_cast<double>(sample.frequency);
        });
    if (above == table.begin() || above == table.end()) return 0;
    const SpectrumSample &low = *(above - 1), &high = *above;
    const double from = low.frequency;
    const double t = (frequency - from) / (static_cast<double>(high.frequency) - from);
    return std::lerp(static_cast<double>(low.density), static_cast<double>(high.density), t) / tau;
}

// By the midpoint rule over equal ratios; below are e^-150 of the peak, above 1e-8 of the whole.
double integrated(const Spectrum& spectrum) {
    constexpr double low = 0.3, high = 100, ratio = 0.005;
    const double first = spectrum.peak * low;
    const auto steps = static_cast<int>(std::log(high / low) / ratio);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double omega = first * std::exp((i + 0.5) * ratio);
        sum += energy(spectrum, omega) * omega * ratio;
    }
    return sum;
}

double tableVariance(std::span<const SpectrumSample> table) {
    double sum = 0;
    for (size_t i = 1; i < table.size(); ++i) {
        const SpectrumSample &low = table[i - 1], &high = table[i];
        sum += 0.5 * (static_cast<double>(low.density) + static_cast<double>(high.density)) *
               (static_cast<double>(high.frequency) - static_cast<double>(low.frequency));
    }
    return sum;
}

} // namespace

Spectrum makeSpectrum(const SeaDesc& desc) {
    switch (desc.spectrum) {
    case SpectrumModel::piersonMoskowitz:
        return piersonMoskowitz(desc.windSpeed);
    case SpectrumModel::tma:
        return tma(desc);
    case SpectrumModel::phillips:
        return phillips(desc.windSpeed);
    case SpectrumModel::table:
        return tabulated(desc);
    case SpectrumModel::jonswap:
        break;
    }
    return jonswap(desc);
}

Spectrum makeSpectrum(const SwellDesc& desc) {
    const auto height = static_cast<double>(desc.height);
    return {.form = Spectrum::Form::swell,
            .peak = tau / static_cast<double>(desc.peakPeriod),
            .variance = height * height / 16,
            .bandwidth = desc.bandwidth};
}

double energy(const Spectrum& spectrum, double omega) {
    if (!(omega > 0)) return 0;
    switch (spectrum.form) {
    case Spectrum::Form::swell:
        return swellEnergy(spectrum, omega);
    case Spectrum::Form::table:
        return tableEnergy(spectrum.table, omega);
    case Spectrum::Form::windSea:
        break;
    }
    return windSeaEnergy(spectrum, omega);
}

double variance(const Spectrum& spectrum) {
    switch (spectrum.form) {
    case Spectrum::Form::swell:
        return spectrum.variance;
    case Spectrum::Form::table:
        return tableVariance(spectrum.table);
    case Spectrum::Form::windSea:
        break;
    }
    return integrated(spectrum);
}

double kitaigorodskii(double omega, double depth) {
    const double deepKh = omega * omega / gravity * depth;
    // From here on the factor is 1 to the last bit, and cosh would overflow later.
    if (!(deepKh < 20)) return 1;
    if (deepKh < 1e-8) return deepKh / 2;
    // Newton for kh tanh(kh) = w^2 h/g, from above.
    double kh = std::max(deepKh, std::sqrt(deepKh)) + 0.2 * std::min(deepKh, 1.0);
    for (int step = 0; step < 6; ++step) {
        const double t = std::tanh(kh);
        kh -= (kh * t - deepKh) / (t + kh * (1 - t * t));
    }
    const double t = std::tanh(kh);
    return t * t / (1 + 2 * kh / std::sinh(2 * kh));
}

double peakWavelength(const Spectrum& spectrum, double depth) {
    return tau / waveNumber(spectrum.peak, depth);
}

} // namespace seaglass
