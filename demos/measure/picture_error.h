#pragma once

#include "measure/tradeoff.h"
#include "reference/reference.h"

namespace demos::measure {

/// What a technique drew, all of one size: linear as the host gives them.
struct Shots {
    Picture color;      ///< Aov::color
    Picture reflection; ///< Aov::reflection
    Picture sources;    ///< Aov::reflectionSource
    Picture scene;      ///< Aov::scene: what techniques look up on the screen
};

/// Shots against the truth, which is of their size. FLIP, PSNR and the share that is wrong are of tone-mapped
/// pictures: of what is seen. Null with `error` set when a picture holds NaN or infinity, since what is
/// measured of such a picture means nothing.
std::optional<PictureError> errorOf(const reference::Pictures& truth, const Shots& shots, double exposureEv,
                                    Error& error);

} // namespace demos::measure
