#include "view/fly_camera.h"

#include <algorithm>
#include <cmath>

#include "host/camera.h"

namespace demos {

namespace {

Vec3 fromGlm(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

void move(CameraDesc& camera, const FlyInput& input, double seconds) {
    const glm::dvec3 forward = glm::normalize(toGlm(camera.targetM) - toGlm(camera.positionM));
    const glm::dvec3 way =
        levelRight(forward) * input.right + glm::dvec3(0, 1, 0) * input.up + forward * input.forward;
    const double length = glm::length(way);
    if (!(length > 0)) return;
    const double speed = input.fast ? fastFlySpeedMps : flySpeedMps;
    // Two keys at once are no faster than one.
    const glm::dvec3 step = way / std::max(length, 1.0) * (speed * seconds);
    camera.positionM = fromGlm(toGlm(camera.positionM) + step);
    camera.targetM = fromGlm(toGlm(camera.targetM) + step);
}

void turn(CameraDesc& camera, const FlyInput& input) {
    if (input.turnRightPx == 0 && input.turnDownPx == 0) return;
    const glm::dvec3 sight = toGlm(camera.targetM) - toGlm(camera.positionM);
    const double distance = glm::length(sight);
    // From +X towards +Z, which is to the right, as the scene's other angles.
    const double azimuth = glm::degrees(std::atan2(sight.z, sight.x)) + input.turnRightPx * flyTurnDegPerPx;
    const double elevation = glm::degrees(std::asin(std::clamp(sight.y / distance, -1.0, 1.0))) -
                             input.turnDownPx * flyTurnDegPerPx;
    const glm::dvec3 towards =
        directionOf(azimuth, std::clamp(elevation, -flySteepestDeg, flySteepestDeg)) * distance;
    camera.targetM = fromGlm(toGlm(camera.positionM) + towards);
}

} // namespace

void fly(CameraDesc& camera, const FlyInput& input, double seconds) {
    turn(camera, input);
    move(camera, input, seconds);
}

} // namespace demos
