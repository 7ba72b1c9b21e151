// Single pixels of light that are like nothing near them in the other picture. FLIP shows a picture as a
// screen would, which ends at white, and so sees little of a firefly beside what is bright.
#pragma once

#include <cstdint>

#include "metrics/image.h"

namespace demos {

struct Outliers {
    uint64_t pixels = 0;
    Place first;
};

/// Pixels of either picture with a channel that is over twice as bright as all that the other picture has
/// within a pixel, by more than the reference's median light; or as far below 0.
Outliers findOutliers(const PixelView& reference, const PixelView& test);

} // namespace demos
