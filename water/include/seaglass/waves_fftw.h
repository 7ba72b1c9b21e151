// The CPU wave backend. FFTW is under the GPL: linking seaglass::waves_fftw puts that licence on the program
// that does. Leave the target out to stay clear of it.
#ifndef SEAGLASS_WAVES_FFTW_H
#define SEAGLASS_WAVES_FFTW_H

#include "seaglass/sea.h"

namespace seaglass {

/// A table that lives for the whole program. Any thread.
const WavesBackend* fftwWaves();

} // namespace seaglass

#endif
