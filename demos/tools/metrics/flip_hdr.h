// HDR-FLIP: the worst FLIP of a pixel over all exposures at which someone might look. Andersson, Nilsson,
// Shirley and Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021.
#pragma once

#include "metrics/flip.h"

namespace demos {

/// Exposures, each a power of two that light is multiplied by.
struct ExposureRange {
    double startEv = 0, stopEv = 0;
    int count = 2; ///< evenly spread, both ends among them
};

/// From where the brightest of a picture is shown at 85 % white, to where its median is. Steps are at most
/// one stop, but for pictures of more than 32 stops. Where more than half of a picture is black, which no
/// exposure shows, the median is that of the rest.
ExposureRange exposureRange(const PixelView& reference);

/// The exposure that shows the median as middle grey (18 %).
double middleGreyEv(const ExposureRange& range);

struct HdrFlip {
    std::vector<float> map; ///< 0 .. 1 for each pixel
    ExposureRange exposures;
};

/// Of linear light without limit; negative counts as none. The exposures are the reference's (the test's,
/// where the reference is black), so this is not symmetric.
HdrFlip hdrFlip(const PixelView& reference, const PixelView& test,
                float pixelsPerDegree = standardPixelsPerDegree);

} // namespace demos
