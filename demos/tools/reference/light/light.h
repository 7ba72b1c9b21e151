// The sky and the sun as the host lights with them, without a device.
#pragma once

#include "host/passes/sky_image.h"
#include "host/water/sun.h"

namespace demos::reference {

struct Light {
    SkyImage image; ///< the sun taken out
    double rotationDeg = 0, intensity = 1;
    SkyLight filtered;
    Sun sun;
    glm::dmat3 axes{1}; ///< along which the directions below are given, in the world

    glm::vec3 toSun() const { return glm::vec3(sun.direction * axes); }
    glm::vec3 sunIrradiance() const { return glm::vec3(sun.irradiance); }

    /// Radiance of the sky without the sun, as sharp as its image.
    glm::vec3 sky(const glm::vec3& direction) const;
    /// Radiance of the sun's disc, its edge softened by half a width `soft` [rad], as the host draws it.
    glm::vec3 sunDisc(const glm::vec3& direction, float soft) const;
    /// Radiance of the sky's cube.
    glm::vec3 cube(const glm::vec3& direction, float mip) const;
    /// Irradiance from the sky on a plane.
    glm::vec3 irradiance(const glm::vec3& normal) const;
    /// A direction to the sun's disc, even over it for even `at` in the unit square.
    glm::vec3 towardsSun(const glm::vec2& at) const;
};

/// Takes the sun out of the image, chooses the one that lights, and filters the rest.
bool makeLight(SkyImage image, const SkyDesc& sky, const SunDesc& sun, Light& out, Error& error);

} // namespace demos::reference
