// What water or floor truly mirrors at a pixel, and whether the picture itself could have told.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

enum class TruthClass : int {
    none = 0, ///< nothing that mirrors is seen here
    sky = 1,
    recoverable = 2, ///< what is mirrored is seen elsewhere in the picture
    offScreen = 3,   ///< ... lies beyond its border
    hidden = 4,      ///< ... is within it, behind something else
    backFacing = 5,  ///< ... is within it, but turned away
    water = 6,       ///< another wave, which no picture of the opaque scene holds
    unsampled = 7,   ///< ... is within it and in sight, but the pixels around all show something else there
};

struct Truth {
    TruthClass kind = TruthClass::none;
    glm::vec2 pixel{
        -1}; ///< where the mirrored point lies in the picture, its border or not; -1 behind the eye
    float distance = 0;    ///< from the surface to it [m]; 0 for the sky
    glm::vec3 radiance{0}; ///< along the mirrored ray
};

/// Of the ray through a point of the picture, mirrored by the mean slope over the pixel.
Truth truthAt(const Frame& frame, const glm::vec2& pixel);

} // namespace demos::reference
