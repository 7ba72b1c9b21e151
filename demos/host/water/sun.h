// The sun that lights a scene: the scene's own, or what its sky holds. CPU only.
#pragma once

#include "host/passes/sky_image.h"

namespace demos {

/// The sun's radius as seen from the Earth [rad], 0.27 degrees.
constexpr double sunRadius = 0.0047;

/// The sun that lights the scene. Below the horizon it gives no light.
struct Sun {
    glm::dvec3 direction{0, 1, 0};
    glm::dvec3 irradiance{0};
};

/// A sun from the sky is taken out of its image, which otherwise stays as it is: nothing is lost. A clear sky
/// becomes the image, and has the sun that belongs to it.
bool chooseSun(const SkyDesc& sky, const SunDesc& desc, SkyImage& image, Sun& out, Error& error);

/// Half the width of the soft edge that the background's disc is drawn with [rad], for pixels of an angle
/// [rad].
double softEdgeOfSun(double pixelAngle);

} // namespace demos
