#include "water/light/sky_colors.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace seaglass {

namespace {

glm::dvec3 toVector(const float (&color)[3]) {
    return {color[0], color[1], color[2]};
}

/// The mean over equal shares of a hemisphere's projection on the plane, which is the irradiance over pi.
glm::dvec3 meanRadiance(const LightingDesc& lighting, const glm::dvec3& normal) {
    if (normal.y == 1) return (toVector(lighting.skyHorizon) + 5.0 * toVector(lighting.skyZenith)) / 6.0;
    constexpr int rings = 16, sectors = 32;
    const glm::dvec3 aside = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
    glm::dvec3 sum(0);
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double squared = (i + 0.5) / rings, angle = 2 * std::numbers::pi * (j + 0.5) / sectors;
            const glm::dvec3 along = std::sqrt(squared) * (std::cos(angle) * u + std::sin(angle) * v) +
                                     std::sqrt(1 - squared) * normal;
            float radiance[3];
            skyRadiance(lighting, {along.x, along.y, along.z}, radiance);
            sum += toVector(radiance);
        }
    return sum / double{rings * sectors};
}

} // namespace

glm::dvec3 skyIrradiance(const LightingDesc& lighting, const glm::dvec3& normal) {
    const glm::dvec3 irradiance = toVector(lighting.skyIrradiance);
    if (lighting.skyCube || irradiance != glm::dvec3(0)) return irradiance;
    return std::numbers::pi * meanRadiance(lighting, normal);
}

} // namespace seaglass
