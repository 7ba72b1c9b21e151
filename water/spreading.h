// Directional spreading: cos^2s(theta/2), its shape s after Hasselmann et al. 1980, elongated by swell after
// Horvath 2015, "Empirical directional wave spectra for computer graphics".
#pragma once

#include "water/spectrum.h"

namespace seaglass {

/// The shape s at a frequency: Hasselmann's, plus 16 tanh(wp/w) swell^2.
double spreadingShape(const Spectrum& spectrum, double omega, double swell);

/// Q(s), which makes Q cos^2s(theta/2) integrate to 1 over the circle; any s >= 0.
double spreadingNorm(double shape);

/// Energy per radian at an angle from the wind of the given cosine.
double spreading(double shape, double cosine);

} // namespace seaglass
