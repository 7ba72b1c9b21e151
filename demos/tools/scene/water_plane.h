// A scene's water as a plane in space.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "scene/scene.h"

namespace demos {

using Plane = std::array<double, 4>; ///< n.p + d = 0, n unit

/// Of level water exactly upwards.
inline Plane waterPlane(const WaterDesc& water) {
    if (water.tiltDeg == 0) return {0, 1, 0, -water.levelM};
    const double tilt = water.tiltDeg * std::numbers::pi / 180,
                 towards = water.tiltTowardsDeg * std::numbers::pi / 180;
    const double up = std::cos(tilt), aside = std::sin(tilt);
    return {aside * std::cos(towards), up, aside * std::sin(towards), -up * water.levelM};
}

/// A point's u, height over the plane, and v, as seaglass/sea.h has them.
inline Vec3 alongPlane(const Plane& plane, const Vec3& point) {
    const auto& [x, y, z, d] = plane;
    const double uphill = x * point[0] + z * point[2];
    const double share = point[1] + uphill / (1 + y);
    return {point[0] - x * share, uphill + y * point[1] + d, point[2] - z * share};
}

} // namespace demos
