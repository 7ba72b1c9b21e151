// Counted before anything is compared: NaN passes every comparison with a limit.
#pragma once

#include <cmath>

#include "metrics/image.h"

namespace demos {

/// Whether +infinity means something in a picture: in one of depth it is the sky.
enum class Infinity { broken, far };

/// Pixels with NaN or infinity in any channel, alpha too.
uint64_t countNotFinite(const PixelView& image, Infinity infinity = Infinity::broken);

/// The first pixel that countNotFinite() counts; image.pixels() where there is none.
size_t firstNotFinite(const PixelView& image);

/// Whether the colour of a pixel is finite.
inline bool isFinite(const PixelView& image, size_t pixel) {
    const float* const rgb = &image.rgba[4 * pixel];
    return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

} // namespace demos
