// Waves that feel the bed: their crests grow narrow, then their fronts steep, until they break. Harmonics
// bound to the trains' sum, of which z = height + i sideways turns with the phase, make z / (1 - c), c in
// proportion to z. How much is Stokes' second order; where along the wave is the biphase that Ruessink et al.
// 2012 found on beaches. The front of a wave that is about to break rises to a wall. The sum's variance
// stays.
#pragma once

#include <array>
#include <complex>

namespace seaglass {

/// The trains at a place, and the water there.
struct SurfPlace {
    double deviation = 0; ///< of their height [m]
    double depth = 0;     ///< of calm water [m]
    double wavesPerMetre = 0;
    double width = 0;    ///< what is much shorter is left out [m]
    double breaking = 0; ///< ShorePlace::breaking
};

struct Surf {
    double height = 0;                  ///< of unit variance
    std::array<double, 2> changes = {}; ///< with that of z's two parts
    double biphase = 0;                 ///< by which fronts come before crests would [rad]
};
Surf surfOf(const std::complex<double>& z, const SurfPlace& place);

/// Cover: a roller on the front of what breaks, and what it leaves until the next, which fades by `fades`
/// e-folds a period.
double surfFoam(const std::complex<double>& z, double biphase, const SurfPlace& place, double fades);

/// The most that a crest rises above the calm level, to the deviation and to the depth.
constexpr double highestSurf = 7, highestSurfToDepth = 0.9;

} // namespace seaglass
