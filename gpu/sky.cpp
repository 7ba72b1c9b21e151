#include "seaglass/host.h"

namespace seaglass {

void skyRadiance(const LightingDesc& lighting, const double (&direction)[3], float (&out)[3]) {
    const double y = direction[1], rises = y < 0 ? -y : y;
    const float(&end)[3] = y < 0 ? lighting.skyGround : lighting.skyZenith;
    const auto share = static_cast<float>(rises * (2 - rises));
    for (int i = 0; i < 3; ++i) out[i] = lighting.skyHorizon[i] + (end[i] - lighting.skyHorizon[i]) * share;
}

} // namespace seaglass
