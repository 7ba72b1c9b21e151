// Linear dispersion of gravity-capillary waves: omega^2 = (g k + (tau/rho) k^3) tanh(k h).
#pragma once

#include <limits>

namespace seaglass {

constexpr double gravity = 9.81;          ///< [m/s^2]
constexpr double surfaceTension = 7.4e-5; ///< tau/rho of sea water [m^3/s^2]
constexpr double deepWater = std::numeric_limits<double>::infinity();

/// Angular frequency [rad/s] of waves of wave number k >= 0 [rad/m] over a depth >= 0 [m].
double angularFrequency(double k, double depth = deepWater);

/// k [rad/m] of waves of an angular frequency > 0 over a depth > 0.
double waveNumber(double omega, double depth = deepWater);

/// d omega / d k [m/s]; 0 at k = 0 in deep water, where the limit is infinite but no wave lives.
double groupSpeed(double k, double depth = deepWater);

} // namespace seaglass
