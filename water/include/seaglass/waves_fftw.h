// The CPU wave backend. FFTW is under the GPL: linking seaglass::waves_fftw puts that licence on the program
// that does. Leave the target out to stay clear of it.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// A table that lives for the whole program. Any thread. With `threads` 2 or more each evaluate() starts a
/// second thread and joins it before it returns, which halves its time; none is kept, and where none can be
/// had the calling thread does it all. The bits are the same.
const WavesBackend* fftwWaves(uint32_t threads = 1);

} // namespace seaglass
