// Which cascades break, and below which Jacobian: set so that foam covers what the whitecap laws say.
#pragma once

#include "seaglass/foam.h"

namespace seaglass {

/// The first `count` cascades break, each by itself: the cover is a sum over scales (Phillips 1985).
struct Breaking {
    uint32_t count = 0;
    float threshold[maxCascades] = {}; ///< Jacobian of the cascade alone, below which it foams
    float softness[maxCascades] = {};  ///< how far below it foams fully
};

Breaking breakingOf(const Sea& sea, const FoamDesc& foam);

} // namespace seaglass
