#pragma once

#include <span>

#include "measure/technique.h"
#include "measure/tradeoff.h"

namespace demos::measure {

struct Shots {
    std::span<const uint8_t> reference, test; ///< tone-mapped alike, RGB
    const Picture* truth = nullptr;           ///< reference::Pictures::truth
    const Picture* classes = nullptr;         ///< Aov::reflectionClass; looked at for Answers::classes alone
};

/// Of pictures of one size. FLIP, PSNR and the share that is wrong are of the tone-mapped pictures: of what
/// is seen.
PictureError errorOf(const Shots& shots, Answers answers);

} // namespace demos::measure
