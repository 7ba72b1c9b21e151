#include <cmath>
#include <limits>

#include "gpu/held_in.h"
#include "seaglass/host.h"

namespace seaglass {

namespace {

float asLight(float radiance) {
    return heldIn(0.0f, std::numeric_limits<float>::max(), radiance);
}

} // namespace

void skyRadiance(const LightingDesc& lighting, const double (&direction)[3], float (&out)[3]) {
    const double y = direction[1], rises = heldIn(0.0, 1.0, std::abs(y));
    const float(&end)[3] = y < 0 ? lighting.skyGround : lighting.skyZenith;
    const auto share = static_cast<float>(rises * (2 - rises));
    for (int i = 0; i < 3; ++i) {
        const float horizon = asLight(lighting.skyHorizon[i]);
        out[i] = horizon + (asLight(end[i]) - horizon) * share;
    }
}

} // namespace seaglass
