// Directional spreading at one frequency, as norm sech^2(beta theta) cos^2s(theta/2).
//
// cos^2s: Longuet-Higgins et al. 1963, with s after Mitsuyasu et al. 1975 or Hasselmann et al. 1980. sech^2:
// Donelan et al. 1985, its tail after Banner 1990. Swell elongates each by cos^2s of s = 16 tanh(wp/w) xi^2
// (Horvath 2015, "Empirical directional wave spectra for computer graphics").
#pragma once

#include "water/spectrum/spectrum.h"

namespace seaglass {

struct Spreading {
    SpreadingModel model = SpreadingModel::hasselmann;
    double shape = 0; ///< s of cosine2s
    double swell = 0; ///< xi
};

/// One model at one frequency.
struct Spread {
    double norm = 0;
    double beta = 0; ///< 0: no sech^2
    double shape = 0;
};

Spread spreadAt(const Spreading& spreading, const Spectrum& spectrum, double omega);

/// Energy per radian at an angle from the mean direction of the given cosine; integrates to 1 over the
/// circle.
double density(const Spread& spread, double cosine);

/// Q(s), which makes Q cos^2s(theta/2) integrate to 1 over the circle; any s >= 0.
double spreadingNorm(double shape);

} // namespace seaglass
