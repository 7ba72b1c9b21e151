#include "water/spectrum/spreading.h"

#include "water/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

constexpr double pi = std::numbers::pi;

double waveAge(const Spectrum& spectrum) {
    return spectrum.wind * spectrum.peak / gravity; // the wind over the peak's phase speed
}

double hasselmannShape(const Spectrum& spectrum, double ratio) {
    if (ratio <= 1) return 6.97 * std::pow(ratio, 4.06);
    return 9.77 * std::pow(ratio, -2.33 - 1.45 * (waveAge(spectrum) - 1.17));
}

double mitsuyasuShape(const Spectrum& spectrum, double ratio) {
    // Long waves in next to no wind would have a shape past all numbers.
    constexpr double sharpest = 1000;
    const double atPeak = std::min(11.5 * std::pow(waveAge(spectrum), -2.5), sharpest);
    return atPeak * std::pow(ratio, ratio <= 1 ? 5 : -2.5);
}

double donelanBannerBeta(double ratio) {
    if (ratio < 0.95) return 2.61 * std::pow(ratio, 1.3);
    if (ratio < 1.6) return 2.28 * std::pow(ratio, -1.3);
    return std::pow(10, -0.4 + 0.8393 * std::exp(-0.567 * std::log(ratio * ratio)));
}

// Longer waves than this are spread evenly all the same, and the norm divides by beta.
constexpr double leastBeta = 1e-6;

// Both factors together have no integral of closed form; that of their product is even, so half the circle
// does: by the midpoint rule in t, theta = pi (1 - t^2), which smooths the end where cos^2s has a root.
double productNorm(double beta, double shape) {
    constexpr int steps = 128;
    const Spread unscaled{.norm = 1, .beta = beta, .shape = shape};
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        sum += 2 * pi * t / steps * density(unscaled, std::cos(pi * (1 - t * t)));
    }
    return 1 / (2 * sum);
}

Spread cosinePower(double shape) {
    return {.norm = spreadingNorm(shape), .beta = 0, .shape = shape};
}

Spread hyperbolicSecant(double beta, double elongation) {
    if (elongation > 0) return {.norm = productNorm(beta, elongation), .beta = beta, .shape = elongation};
    return {.norm = beta / (2 * std::tanh(beta * pi)), .beta = beta, .shape = 0};
}

} // namespace

Spread spreadAt(const Spreading& spreading, const Spectrum& spectrum, double omega) {
    const double ratio = omega / spectrum.peak;
    const double elongation = 16 * std::tanh(1 / ratio) * spreading.swell * spreading.swell;
    switch (spreading.model) {
    case SpreadingModel::mitsuyasu:
        return cosinePower(mitsuyasuShape(spectrum, ratio) + elongation);
    case SpreadingModel::donelanBanner:
        return hyperbolicSecant(std::max(donelanBannerBeta(ratio), leastBeta), elongation);
    case SpreadingModel::cosine2s:
        return cosinePower(spreading.shape + elongation);
    case SpreadingModel::hasselmann:
        break;
    }
    return cosinePower(hasselmannShape(spectrum, ratio) + elongation);
}

double density(const Spread& spread, double cosine) {
    double value = spread.norm;
    if (spread.shape > 0) {
        const double cosineSquaredOfHalf = std::max(0.5 * (1 + cosine), 0.0);
        value *= std::pow(cosineSquaredOfHalf, spread.shape);
    }
    if (spread.beta > 0) {
        const double cosh = std::cosh(spread.beta * std::acos(std::clamp(cosine, -1.0, 1.0)));
        value /= cosh * cosh;
    }
    return value;
}

// By Legendre's duplication Q = 2^(2s-1)/pi Gamma(s+1)^2/Gamma(2s+1) is Gamma(s+1) / (2 sqrt(pi)
// Gamma(s+1/2)). That ratio is climbed to where its asymptotic series holds to 1e-10: nothing overflows, and
// no lgamma is called, for whose global signgam threads would race.
double spreadingNorm(double shape) {
    double s = shape;
    double climbed = 1;
    for (; s < 32; s += 1) climbed *= (s + 0.5) / (s + 1);
    const double z = 1 / s;
    const double ratioSquared =
        s * (1 + z * (1.0 / 4 + z * (1.0 / 32 + z * (-1.0 / 128 + z * (-5.0 / 2048)))));
    return climbed * std::sqrt(ratioSquared) / (2 * std::sqrt(std::numbers::pi));
}

} // namespace seaglass
