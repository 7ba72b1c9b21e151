// The systems of waves that a sea is the sum of: a wind sea and swells, each with its spectrum, spreading and
// direction, over one depth.
#pragma once

#include "water/spectrum/spreading.h"

#include <array>

namespace seaglass {

struct WaveSystem {
    Spectrum spectrum;
    Spreading spreading;
    double direction = 0; ///< where its waves run, from +u to +v [rad]
};

struct WaveSystems {
    std::array<WaveSystem, 1 + maxSwells> system;
    uint32_t count = 0; ///< 0 when flat
    double depth = deepWater;
};

/// Of a valid description, without those that have no height. Refers to the description's table.
WaveSystems makeSystems(const SeaDesc& desc);

/// S(omega) of all systems [m^2 s].
double energy(const WaveSystems& systems, double omega);

/// The integral of S of all systems [m^2].
double variance(const WaveSystems& systems);

/// Height variance per wave number of all systems and directions [m^3], k > 0.
double waveNumberSpectrum(const WaveSystems& systems, double k);

/// The one with the greatest peak; the systems are not flat.
const WaveSystem& dominantSystem(const WaveSystems& systems);

} // namespace seaglass
