#pragma once

#include "metrics/compare.h"

namespace demos {

/// For pictures of one renderer on one driver, before and after a change: wide enough for rounding that moves
/// an edge here and there by a pixel, too narrow for a lost mast. Its test holds each limit to planted
/// defects.
Limits tolerantLimits(PictureKind kind);

} // namespace demos
