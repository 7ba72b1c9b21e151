// The camera in double precision: a view matrix that survives any place and direction, and a projection with
// reversed depth, infinite unless lines of sight are parallel.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/surroundings.h"

namespace demos {

struct Camera {
    glm::dvec3 eye{0};
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    glm::dmat4 view{1};       ///< world to view, eye included
    glm::dmat4 rotation{1};   ///< world directions to view: the view matrix of an eye at the origin
    glm::dmat4 projection{1}; ///< view to clip; y points down as Vulkan's does
    double tanHalfFovX = 1, tanHalfFovY = 1; ///< 0 where lines of sight are parallel
    glm::dvec2 half{0};                      ///< of what those show [m]; 0 where they come from the eye
    double near = 0.1, far = 0;              ///< 0: infinite
    glm::dmat4 toldProjection{1};            ///< what the library is told: a Mistake apart, the projection
    glm::dvec2 jitterPx{0};                  ///< by which `projection` moves the picture, right and down
    bool follows = false;                    ///< the frame before

    bool parallel() const { return half.y > 0; }
    /// Relative to the eye, `distance` along the axis: (x, y) from -1 to 1 across the picture, y up.
    glm::dvec3 seenAt(double x, double y, double distance) const {
        return distance * (forward + right * (x * tanHalfFovX) + up * (y * tanHalfFovY)) +
               right * (x * half.x) + up * (y * half.y);
    }
    /// Along the axis, of a point with this depth in the picture [m].
    double distanceOf(double depth) const {
        if (parallel()) return far - depth * (far - near);
        return depth > 0 ? near / depth : std::numeric_limits<double>::infinity();
    }
};

/// By parallel lines of sight, to 10 km or 20 times as far as they show across.
inline void makeParallel(double heightM, double aspect, Camera& out) {
    out.tanHalfFovX = out.tanHalfFovY = 0;
    out.half = glm::dvec2(aspect, 1) * (heightM / 2);
    out.far = out.near + std::max(1e4, 20 * heightM);
    out.projection = glm::dmat4(1);
    out.projection[0][0] = 1 / out.half.x;
    out.projection[1][1] = -1 / out.half.y;
    out.projection[2][2] = 1 / (out.far - out.near);
    out.projection[3][2] = out.far / (out.far - out.near);
}

inline glm::dvec3 toGlm(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

/// The right vector of a level camera. Straight up or down it is +X, as if tilted there from looking along
/// -Z.
inline glm::dvec3 levelRight(const glm::dvec3& forward) {
    const glm::dvec3 right = glm::cross(forward, glm::dvec3(0, 1, 0));
    const double length = glm::length(right);
    return length > 1e-9 ? right / length : glm::dvec3(1, 0, 0);
}

inline bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// False with `error` set for a camera that sees nothing: target on the eye, or a field out of range.
inline bool makeCamera(const CameraDesc& desc, double aspect, Camera& out, Error& error) {
    const std::string who = "camera \"" + desc.name + "\": ";
    const glm::dvec3 eye = toGlm(desc.positionM);
    const glm::dvec3 towards = toGlm(desc.targetM) - eye;
    if (!finite(eye) || !finite(towards) || !std::isfinite(desc.rollDeg)) {
        error.text = who + "position, target and roll must be finite";
        return false;
    }
    if (!(glm::length(towards) > 0)) {
        error.text = who + "target and position are the same place";
        return false;
    }
    if (!(desc.verticalFovDeg >= 1 && desc.verticalFovDeg <= 179)) {
        error.text =
            who + "vertical field of view is " + std::to_string(desc.verticalFovDeg) + ", expected 1 to 179";
        return false;
    }
    if (!(desc.nearM >= 1e-6 && desc.nearM <= 1e6)) {
        error.text = who + "near is " + std::to_string(desc.nearM) + " m, expected 1e-6 to 1e6";
        return false;
    }
    out.eye = eye;
    out.forward = glm::normalize(towards);
    const glm::dvec3 level = levelRight(out.forward);
    const glm::dvec3 upright = glm::cross(level, out.forward);
    const double roll = glm::radians(desc.rollDeg);
    out.right = level * std::cos(roll) - upright * std::sin(roll);
    out.up = level * std::sin(roll) + upright * std::cos(roll);
    out.rotation = glm::transpose(glm::dmat4(glm::dvec4(out.right, 0), glm::dvec4(out.up, 0),
                                             glm::dvec4(-out.forward, 0), glm::dvec4(0, 0, 0, 1)));
    out.view = glm::translate(out.rotation, -eye);
    out.tanHalfFovY = std::tan(glm::radians(desc.verticalFovDeg) / 2);
    out.tanHalfFovX = out.tanHalfFovY * aspect;
    out.near = desc.nearM;
    out.projection = glm::dmat4(0);
    out.projection[0][0] = 1 / out.tanHalfFovX;
    out.projection[1][1] = -1 / out.tanHalfFovY;
    out.projection[2][3] = -1;
    out.projection[3][2] = desc.nearM;
    if (desc.orthographicHeightM > 0) makeParallel(desc.orthographicHeightM, aspect, out);
    out.toldProjection = out.projection;
    return true;
}

/// The unit vector towards a place on the sky: azimuth from +X towards +Z, elevation above the horizon.
inline glm::dvec3 directionOf(double azimuthDeg, double elevationDeg) {
    const double azimuth = glm::radians(azimuthDeg), elevation = glm::radians(elevationDeg);
    return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
            std::cos(elevation) * std::sin(azimuth)};
}

} // namespace demos
