#pragma once

#include "measure/shots.h"
#include "measure/tradeoff.h"
#include "reference/reference.h"

namespace demos::measure {

/// RGBA as a screen shows it: tone-mapped, display-encoded, 0..1.
std::vector<float> displayed(const Picture& picture, double exposureEv);

/// Shots against the truth, which is of their size. FLIP, PSNR and the share that is wrong are of tone-mapped
/// pictures: of what is seen. Null with `error` set when a picture holds NaN or infinity, since what is
/// measured of such a picture means nothing.
std::optional<PictureError> errorOf(const reference::Pictures& truth, const Shots& shots, double exposureEv,
                                    Error& error);

} // namespace demos::measure
