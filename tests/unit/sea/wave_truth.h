// The maps of a cascade in double: each mode's height from the definition, its phase by fmod in long double,
// and double transforms of one field at a time. Shares no code with what it checks, and asks for no library.
#pragma once

#include "water/sea/sea.h"

#include <array>
#include <vector>

namespace tests {

using namespace seaglass;

/// In the order of displacement, then derivatives: Dx, h, Dz, dDx/dv, dh/du, dh/dv, dDx/du, dDz/dv.
constexpr size_t waveFields = 8;
using WaveTruth = std::array<std::vector<double>, waveFields>;

WaveTruth waveTruth(const Sea& sea, uint32_t cascade, double time);

double rootMeanSquare(const std::vector<double>& values);

/// How far maps of `samples`^2 texels are from the truth.
struct WaveError {
    std::array<double, waveFields> relative{}; ///< in L2
    double worst = 0;                          ///< of the three displacements [m]
};
WaveError waveError(const WaveTruth& truth, const std::vector<float>& displacement,
                    const std::vector<float>& derivatives);

} // namespace tests
