#include "water/waves/wave_detail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "water/sea/sea.h"

namespace seaglass {

WaveDetail::WaveDetail(const Sea& sea) {
    const std::array<double, waveOctaves> variance = varianceByOctave(sea, 0);
    const double sideways = std::max(1.0, double{description(sea).choppiness});
    double sum = 0;
    for (size_t i = waveOctaves; i-- > 0;) {
        sum += variance[i];
        // What a bed makes of the waves is not among their modes.
        lost_[i] = sea.shore ? std::numeric_limits<double>::infinity() : sideways * std::sqrt(sum);
    }
}

double WaveDetail::lostBetween(double cell) const {
    // A wave is drawn from four cells to its length on.
    return lost_[static_cast<size_t>(octaveOf(4 * cell))];
}

} // namespace seaglass
