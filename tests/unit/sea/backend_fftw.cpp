#include "seaglass/waves_fftw.h"
#include "tests/unit/sea/sea_support.h"

namespace tests {

using namespace seaglass;

const WavesBackend& builtBackend() {
    return *fftwWaves();
}

} // namespace tests
