// shaders/common/optics.glsl on the CPU: light at the boundary of air and water.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos::reference {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float waterIndex = 1.333f;

/// Exact unpolarised dielectric reflectance from air into water (Born and Wolf 1999, 1.5.2).
inline float fresnelWater(float cosIncidence) {
    const float c = std::clamp(cosIncidence, 0.0f, 1.0f);
    const float g = std::sqrt(waterIndex * waterIndex - 1 + c * c);
    const float a = (g - c) / (g + c);
    const float b = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5f * a * a * (1 + b * b);
}

/// From water into air, where beyond the critical angle all of it stays.
inline float fresnelFromWater(float cosIncidence) {
    const float c = std::clamp(cosIncidence, 0.0f, 1.0f);
    const float sine2 = waterIndex * waterIndex * (1 - c * c);
    return sine2 >= 1 ? 1.0f : fresnelWater(std::sqrt(1 - sine2));
}

/// Smith's masking function for Gaussian slopes (rational fit: Walter et al. 2007).
inline float smithLambda(float c, float deviation) {
    const float tangent = std::sqrt(std::max(1 - c * c, 0.0f)) / std::max(c, 1e-4f);
    const float a = 1 / std::max(1.41421356f * deviation * tangent, 1e-6f);
    return a >= 1.6f ? 0.0f : (1 - 1.259f * a + 0.396f * a * a) / (3.535f * a + 2.181f * a * a);
}

/// Density of Gaussian slopes with covariance (uu, vv, uv) at a distance `d` from their mean.
inline float slopeDensity(const glm::vec2& d, const glm::vec3& covariance) {
    const float determinant = std::max(covariance.x * covariance.y - covariance.z * covariance.z, 1e-12f);
    const float exponent =
        (covariance.y * d.x * d.x - 2 * covariance.z * d.x * d.y + covariance.x * d.y * d.y) / determinant;
    return std::exp(-0.5f * exponent) / (2 * pi * std::sqrt(determinant));
}

inline glm::vec3 normalOf(const glm::vec2& slope) {
    return glm::normalize(glm::vec3(-slope.x, 1, -slope.y));
}

} // namespace demos::reference
