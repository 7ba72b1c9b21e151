// The sky of a clear day, from where the sun stands. CPU only.
#pragma once

#include "host/passes/sky_image.h"

namespace demos {

/// A lat-long picture without the sun's disc, and the sun's irradiance on a plane that faces it. Both are in
/// one scale, whatever the sun's elevation: in the evening both are darker.
struct ClearSky {
    SkyImage image;
    glm::dvec3 sunIrradiance{0};
};

/// Single scattering by air, haze and ozone, and the higher orders after Hillaire 2020, "A Scalable and
/// Production Ready Sky and Atmosphere Rendering Technique", seen from 2 m. `sunAzimuth` is in the picture's
/// frame; both angles in radians. `haze` scales aerosols: 1 is clean air, 10 a hazy day.
ClearSky clearSky(double sunAzimuth, double sunElevation, double haze);

} // namespace demos
