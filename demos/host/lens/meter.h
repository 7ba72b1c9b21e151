// A light meter: what exposure a picture asks for.
#pragma once

#include "host/host.h"

namespace demos {

/// Stops to add before tone mapping, as a camera would choose them. The mean of the luminance's logarithm
/// comes out where the demo scenes have it (Reinhard et al. 2002), or lower where the sun's path would burn
/// out. 0 for a picture without light.
double meteredEv(const Picture& picture);

} // namespace demos
