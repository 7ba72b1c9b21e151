// How far a picture is from the one it should be, by several measures at once: a mean forgives a spot, a
// maximum forgives nothing.
#pragma once

#include <cstdint>
#include <string>

#include "demos/host/host.h"

namespace tests {

/// Of values 0..1, colour only.
struct Difference {
    bool sameSize = false;
    double most = 0;       ///< the greatest, over all pixels and channels
    double mean = 0;       ///< over all pixels and channels
    double shareSmall = 0; ///< share of pixels that differ by more than Limits::small in some channel
    double shareLarge = 0; ///< share of pixels that differ by more than Limits::large
};

/// Wide enough for another CPU's rounding, which moves a few wave crests and edges by a pixel; too narrow for
/// a change that an eye would see.
struct Limits {
    double small = 3.0 / 255;
    double large = 24.0 / 255;
    double shareSmall = 0.01;
    double shareLarge = 0.0005;
    double mean = 0.5 / 255;
};

Difference compare(const demos::Picture& expected, const demos::Picture& actual, const Limits& limits);

/// What is beyond the limits, in words; empty when nothing is.
std::string objections(const Difference& difference, const Limits& limits);

/// Pixels with NaN or infinity in any channel.
uint64_t countNotFinite(const demos::Picture& picture);

/// Ten times the difference around mid grey, RGB.
std::vector<uint8_t> differencePicture(const demos::Picture& expected, const demos::Picture& actual);

} // namespace tests
