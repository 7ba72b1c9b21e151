// One-dimensional frequency spectra of the height of a wind sea, S(omega) [m^2 s].
//
// Pierson and Moskowitz 1964; JONSWAP: Hasselmann et al. 1973.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// S = alpha g^2 w^-5 exp(-5/4 (wp/w)^4) gamma^r, r = exp(-(w - wp)^2 / (2 sigma^2 wp^2)), sigma 0.07 up to
/// the peak and 0.09 past it.
struct Spectrum {
    double alpha = 0;
    double peak = 0; ///< wp [rad/s]
    double gamma = 1;
    double wind = 0; ///< U10 [m/s]
};

/// From the wind, the fetch and the model of a valid description; its wind must not be 0.
Spectrum makeSpectrum(const SeaDesc& desc);

/// S(omega) [m^2 s]; 0 for omega <= 0.
double energy(const Spectrum& spectrum, double omega);

/// Of the waves at the peak, in deep water [m].
double peakWavelength(const Spectrum& spectrum);

} // namespace seaglass
