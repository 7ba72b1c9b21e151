// How far the values of two pictures of one size are apart, channel by channel.
#pragma once

#include "metrics/image.h"

namespace demos {

/// Over red, green and blue, but for `alpha`, of all pixels that are finite in both.
struct Difference {
    double mean = 0;
    double meanSquare = 0;
    double max = 0;
    double alpha = 0; ///< the greatest of alpha
};

/// Of the pixels `leftOut` count as none; both pictures have the same there.
Difference difference(const PixelView& a, const PixelView& b, size_t leftOut = 0);

/// Share of the pixels, 0..1, that differ by more than `limit` in some channel, alpha too. Those with NaN or
/// infinity do.
double shareOver(const PixelView& a, const PixelView& b, double limit);

/// The same of alpha alone.
double shareOfAlphaOver(const PixelView& a, const PixelView& b, double limit);

/// Of those the share that is also off by more than `limit` from the range of what the other picture has
/// within a pixel, in either picture: a firefly is, an edge that moves is not.
double shareUnlikeAround(const PixelView& a, const PixelView& b, double limit);

} // namespace demos
