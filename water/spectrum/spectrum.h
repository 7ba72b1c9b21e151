// One-dimensional frequency spectra of the height of one system of waves, S(omega) [m^2 s].
//
// Pierson and Moskowitz 1964; JONSWAP: Hasselmann et al. 1973; TMA: Bouws et al. 1985; Phillips 1958 as cut
// off by Tessendorf 2001. A swell is a Gaussian of frequency.
#pragma once

#include "seaglass/sea.h"
#include "water/spectrum/dispersion.h"

#include <span>

namespace seaglass {

struct Spectrum {
    enum class Form {
        windSea, ///< S = alpha g^2 w^-5 exp(-5/4 (wp/w)^4) gamma^r, r = exp(-(w - wp)^2 / (2 sigma^2 wp^2)),
                 ///< sigma 0.07 up to the peak and 0.09 past it; times Kitaigorodskii's factor
        swell,   ///< a Gaussian of `variance` about the peak, `bandwidth` wp wide
        table
    };

    Form form = Form::windSea;
    double peak = 0; ///< wp [rad/s]
    double wind = 0; ///< U10 [m/s]; 0 for swells

    double alpha = 0;
    double gamma = 1;
    double depth = deepWater; ///< of Kitaigorodskii's factor [m]

    double variance = 0; ///< [m^2]
    double bandwidth = 0;

    std::span<const SpectrumSample> table;
};

/// From the wind, the fetch and the model of a valid description; its wind must not be 0. A table is referred
/// to.
Spectrum makeSpectrum(const SeaDesc& desc);

/// Of a valid description whose height is not 0.
Spectrum makeSpectrum(const SwellDesc& desc);

/// S(omega) [m^2 s]; 0 for omega <= 0.
double energy(const Spectrum& spectrum, double omega);

/// The integral of S [m^2].
double variance(const Spectrum& spectrum);

/// What a bottom at `depth` > 0 leaves of a wind sea's energy, 0..1 (Kitaigorodskii et al. 1975, exact form).
double kitaigorodskii(double omega, double depth);

/// Of the waves at the peak over a depth > 0 [m].
double peakWavelength(const Spectrum& spectrum, double depth = deepWater);

} // namespace seaglass
