#include "seaglass/waves_fftw.h"
#include "tests/unit/sea/sea_support.h"

namespace seaglass::tests {

const WavesBackend& builtBackend() {
    return *fftwWaves();
}

} // namespace seaglass::tests
