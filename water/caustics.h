// Which waves gather light at which depth.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// Light from the surface has crossed by `depth` from all waves that are narrower than 2^log2Scale
/// depth^exponent metres, about, and lights what lies there evenly.
struct CausticBlur {
    double log2Scale = 0;
    double exponent = 1;
};

/// A line through the logarithms of both, by least squares over the sea's own modes.
CausticBlur causticBlurOf(const Sea& sea);

} // namespace seaglass
