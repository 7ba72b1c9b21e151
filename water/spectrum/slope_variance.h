// One budget of slope variance, that of Cox and Munk: what the cascades hold, and the surface's roughness,
// which is the rest.
#pragma once

#include "water/interface/sea_contents.h"

namespace seaglass {

/// Where the spectrum's short waves are steeper than Cox and Munk saw in so little wind, lowers them by a
/// power of the wave number, so that all down to 17 mm have the budget. The modes are drawn.
void limitSlopes(Sea& sea);

/// Of the waves that the modes hold.
SlopeCovariance slopesOf(const Sea& sea);

/// What is missing from the budget.
SlopeCovariance roughnessOf(const Sea& sea, const SlopeCovariance& resolved);

} // namespace seaglass
