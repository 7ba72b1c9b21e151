#include "host/water/sun.h"

#include <algorithm>

#include "host/camera.h"
#include "host/passes/clear_sky.h"

namespace demos {

bool chooseSun(const SkyDesc& sky, const SunDesc& desc, SkyImage& image, Sun& out, Error& error) {
    if (sky.clear) {
        ClearSky made = clearSky(glm::radians(desc.azimuthDeg - sky.rotationDeg),
                                 glm::radians(desc.elevationDeg), sky.haze);
        image = std::move(made.image);
        out.direction = directionOf(desc.azimuthDeg, desc.elevationDeg);
        out.irradiance = made.sunIrradiance * sky.intensity;
    } else if (desc.fromSky) {
        const ImageSun inImage = takeOutSun(image);
        const double angle = glm::radians(sky.rotationDeg), c = std::cos(angle), s = std::sin(angle);
        const glm::dvec3& d = inImage.direction;
        out.direction = {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
        out.irradiance = inImage.irradiance * sky.intensity;
    } else {
        out.direction = directionOf(desc.azimuthDeg, desc.elevationDeg);
        out.irradiance = toGlm(desc.irradiance);
    }
    if (!finite(out.direction) || !finite(out.irradiance) ||
        glm::any(glm::lessThan(out.irradiance, glm::dvec3(0)))) {
        error.text = "the sun's direction and irradiance must be finite, and the irradiance not negative";
        return false;
    }
    if (out.direction.y <= 0) out.irradiance = glm::dvec3(0);
    return true;
}

double softEdgeOfSun(double pixelAngle) {
    return std::min(0.9 * sunRadius, std::max(0.1 * sunRadius, 0.75 * pixelAngle));
}

} // namespace demos
