// shaders/gpu/optics.glsl on the CPU: light at the boundary of air and water.
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

/// Density of Gaussian slopes with covariance (uu, vv, uv) at a distance `d` from their mean.
inline float slopeDensity(const glm::vec2& d, const glm::vec3& covariance) {
    const float determinant = std::max(covariance.x * covariance.y - covariance.z * covariance.z, 1e-12f);
    const float exponent =
        (covariance.y * d.x * d.x - 2 * covariance.z * d.x * d.y + covariance.x * d.y * d.y) / determinant;
    return std::exp(-0.5f * exponent) / (2 * pi * std::sqrt(determinant));
}

/// Of the unit Gaussian what lies below e, within 1.4e-4 (Page 1977).
inline float gaussianBelow(float e) {
    return 1 / (1 + std::exp(-e * (1.5976f + 0.070566f * e * e)));
}

/// Below what deviation a share of the unit Gaussian lies, within 3e-3 (Hastings 1955, sheet 67).
inline float gaussianQuantile(float share) {
    const float t = std::sqrt(-2 * std::log(std::max(std::min(share, 1 - share), 1e-6f)));
    const float away = t - (2.30753f + 0.27061f * t) / (1 + t * (0.99229f + 0.04481f * t));
    return share < 0.5f ? -away : away;
}

/// Mean of e - x over all x of the unit Gaussian that are less.
inline float meanAbove(float e) {
    const float within = std::max(e, -2.0f);
    return within * gaussianBelow(within) + 0.398942f * std::exp(-0.5f * within * within);
}

/// Gaussian slopes along a direction above the surface, in deviations below that at which they are edge on.
struct SlopesAlong {
    float aside, deviation, edgeOn;
};

inline SlopesAlong slopesAlong(const glm::vec3& direction, const glm::vec2& mean,
                               const glm::vec3& covariance) {
    const float aside = std::max(glm::length(glm::vec2(direction.x, direction.z)), 1e-6f);
    const glm::vec2 along = glm::vec2(direction.x, direction.z) / aside;
    const float variance =
        glm::dot(along * along, glm::vec2(covariance)) + 2 * along.x * along.y * covariance.z;
    const float deviation = std::sqrt(std::max(variance, 1e-10f));
    return {aside, deviation, (direction.y / aside - glm::dot(mean, along)) / deviation};
}

/// How large level area is to the eye, its facets that are seen from behind left out.
inline float visibleArea(const SlopesAlong& s) {
    return std::max(s.aside * s.deviation * meanAbove(s.edgeOn), 1e-4f);
}

/// Share of the rays along the direction that get past the slopes (Smith 1967).
inline float clearShareOf(const SlopesAlong& s) {
    return s.edgeOn <= 0 ? 0.0f : s.edgeOn / meanAbove(s.edgeOn);
}

inline glm::vec3 normalOf(const glm::vec2& slope) {
    return glm::normalize(glm::vec3(-slope.x, 1, -slope.y));
}

} // namespace demos::reference
