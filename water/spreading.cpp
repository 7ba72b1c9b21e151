#include "water/spreading.h"

#include "water/dispersion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seaglass {

double spreadingShape(const Spectrum& spectrum, double omega, double swell) {
    const double ratio = omega / spectrum.peak;
    const double windsea =
        ratio <= 1 ? 6.97 * std::pow(ratio, 4.06)
                   : 9.77 * std::pow(ratio, -2.33 - 1.45 * (spectrum.wind * spectrum.peak / gravity - 1.17));
    return windsea + 16 * std::tanh(1 / ratio) * swell * swell;
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

double spreading(double shape, double cosine) {
    const double cosineSquaredOfHalf = std::max(0.5 * (1 + cosine), 0.0);
    return spreadingNorm(shape) * std::pow(cosineSquaredOfHalf, shape);
}

} // namespace seaglass
