// What a sea is made of, for those who evaluate, measure or draw it: cascades, spectrum and slopes.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// One band of wave vectors on its own tile. Each wave vector of the sea lives in exactly one cascade.
struct Cascade {
    double patch = 0;     ///< tile edge [m]
    uint32_t samples = 0; ///< across the tile
    double kMin = 0;      ///< wave numbers kMin <= k < kMax [rad/m]; at least 4 samples a wave
    double kMax = 0;      ///< likewise
    double variance = 0;  ///< of height, from the modes it holds [m^2]
};

uint32_t cascadeCount(const Sea& sea);                  ///< 0 when the sea is flat
const Cascade& cascade(const Sea& sea, uint32_t index); ///< index < cascadeCount
/// S(omega) of all systems together as asked for, resolved or not [m^2 s]; 0 when flat.
double frequencySpectrum(const Sea& sea, double omega);

/// Variances and covariance of the surface's slopes.
struct SlopeCovariance {
    double uu = 0; ///< of dh/du
    double vv = 0; ///< of dh/dv
    double uv = 0; ///< of both
};

SlopeCovariance resolvedSlopes(const Sea& sea); ///< of the waves that the cascades hold
/// Of all that is shorter. With the resolved slopes it makes Cox and Munk's variance, times amplitude^2.
SlopeCovariance roughness(const Sea& sea);

/// Slope variance of a clean sea, both axes together, 0.003 + 5.12e-3 U at 12.5 m (Cox and Munk 1954), from
/// U10 [m/s]: less below 1 m/s, where water turns to glass, and no more past 30 m/s.
double coxMunkSlopeVariance(double windSpeed);

} // namespace seaglass
