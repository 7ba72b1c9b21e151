// A ray with the width of what it stands for. Positions are in metres from the eye, so that a float serves
// anywhere.
#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos::reference {

/// The rays of the pixels, or of the samples, to the right and below, as far as they tell how finely a
/// surface is looked at: both leave from `apex`, where the whole path would begin were it straight.
struct Footprint {
    glm::vec3 apex{0};
    glm::vec3 right{0}, below{0}; ///< directions
    float angle = 0;              ///< from the ray to either [rad], in the middle of the picture
};

struct Ray {
    glm::vec3 origin{0};
    glm::vec3 direction{0, 0, -1}; ///< unit
    float nearest = 0;             ///< hits before this distance do not count
    bool inWater = false;          ///< it begins there; kept of water that may be seen from within
    Footprint footprint;
};

/// What lies `travelled` metres behind a bend in the path sees the next rays at `angle` from its own.
inline Footprint footprintAfter(const glm::vec3& origin, const glm::vec3& direction, float travelled,
                                float angle) {
    const glm::vec3 other = glm::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(direction, other));
    const glm::vec3 below = glm::cross(direction, right);
    return {origin - direction * travelled, direction + right * angle, direction + below * angle, angle};
}

/// Where the neighbours meet the plane through `at`, relative to it. A plane that they miss is taken as far
/// away.
struct Spread {
    glm::vec3 right{0}, below{0};
};
inline Spread spreadOn(const Footprint& footprint, const glm::vec3& at, const glm::vec3& normal) {
    const float height = glm::dot(at - footprint.apex, normal);
    const auto meet = [&](const glm::vec3& direction) {
        const float along = glm::dot(direction, normal);
        const float t = along * height > 0 ? height / along : 1e6f;
        return footprint.apex + direction * glm::min(t, 1e6f) - at;
    };
    return {meet(footprint.right), meet(footprint.below)};
}

} // namespace demos::reference
