#pragma once

#include "metrics/image.h"

namespace demos {

/// How much of a picture comes again elsewhere in it: the largest value of its autocorrelation, 1 at the
/// origin, of lags longer than `beyond` pixels. Of luminance less the surface of second order that fits it
/// best, so that light which falls off across the picture is no repetition; beyond its edges there is
/// nothing. Square, a side a power of two.
struct Repetition {
    double most = 0;
    int right = 0, down = 0; ///< the lag
};
Repetition repetition(const PixelView& image, double beyond = 20);

} // namespace demos
