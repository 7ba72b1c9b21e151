// Where FFTW is left out: the maps as wave_truth.h has them.
#include "tests/unit/sea/sea_support.h"
#include "tests/unit/sea/wave_truth.h"

#include <cmath>

namespace tests {

using namespace seaglass;
namespace {

void* create(const Sea& sea) {
    return new const Sea*(&sea);
}

void destroy(void* state) {
    delete static_cast<const Sea**>(state);
}

void evaluate(void* state, uint32_t cascade, double time, const CascadeMaps& out) {
    const Sea& sea = **static_cast<const Sea**>(state);
    const WaveTruth truth = waveTruth(sea, cascade, std::isfinite(time) ? time : 0);
    for (size_t t = 0; t < truth[0].size(); ++t) {
        for (size_t f = 0; f < 4; ++f) {
            out.displacement[4 * t + f] = static_cast<float>(truth[f][t]);
            out.derivatives[4 * t + f] = static_cast<float>(truth[4 + f][t]);
        }
        const float slopeU = out.derivatives[4 * t], slopeV = out.derivatives[4 * t + 1];
        float* const moments = out.moments + 4 * t;
        moments[0] = slopeU * slopeU;
        moments[1] = slopeV * slopeV;
        moments[2] = slopeU * slopeV;
        moments[3] = out.displacement[4 * t + 3];
    }
}

} // namespace

const WavesBackend& builtBackend() {
    static constexpr WavesBackend backend{"plain", create, destroy, evaluate};
    return backend;
}

} // namespace tests
