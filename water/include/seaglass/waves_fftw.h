// The CPU wave backend. FFTW is under the GPL: linking seaglass::waves_fftw puts that licence on the program.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// It lives as long as the program. Any thread. With `threads` 2 or more each evaluate() starts a second
/// thread, if one can be had, and joins it before it returns: half the time, the same bits.
const WavesBackend* fftwWaves(uint32_t threads = 1);

} // namespace seaglass
