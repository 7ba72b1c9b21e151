// How much of a sea's waves a mesh can show.
#pragma once

#include <array>

#include "water/waves/wave_octaves.h"

namespace seaglass {

class WaveDetail {
  public:
    /// Of still water.
    WaveDetail() = default;
    explicit WaveDetail(const Sea& sea);

    /// Deviation of what a mesh of such cells leaves out of the surface's place [m].
    double lostBetween(double cell) const;

  private:
    std::array<double, waveOctaves> lost_{}; ///< deviation of all waves from the octave on
};

} // namespace seaglass
