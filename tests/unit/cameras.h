// Cameras that tests look from: built in double, as a host would.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "seaglass/host.h"

namespace tests {

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

struct Camera {
    glm::dvec3 eye{0, 2, 10};
    glm::dvec3 target{0, 1, 0};
    double rollDegrees = 0;
    double fovDegrees = 50;
    double near = 0.1;
    double far = 0;            ///< 0: infinite
    double parallelHeight = 0; ///< of what is seen, by parallel lines of sight [m]; 0: from the eye
    glm::dvec2 offCentre{0};   ///< by which what is seen lies beside the axis, of its half width and height
    bool reversed = true;
    glm::dvec2 jitter{0}; ///< by which all of the picture is moved [pixel]
    uint32_t width = 256, height = 144;
};

inline glm::dmat4 viewMatrix(const Camera& camera) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 helper = std::abs(forward.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const glm::dmat4 roll = glm::rotate(glm::dmat4(1), radians(camera.rollDegrees), glm::dvec3(0, 0, 1));
    return roll * glm::lookAt(camera.eye, camera.target, helper);
}

inline glm::dmat4 parallelProjection(const Camera& camera) {
    const glm::dvec2 shift = 2.0 * camera.jitter / glm::dvec2(camera.width, camera.height) - camera.offCentre;
    const double depth = camera.far - camera.near;
    glm::dmat4 p(1);
    p[0][0] = 2 / camera.parallelHeight * camera.height / camera.width;
    p[1][1] = -2 / camera.parallelHeight;
    p[2][2] = (camera.reversed ? 1 : -1) / depth;
    p[3] = {shift, camera.reversed ? camera.far / depth : -camera.near / depth, 1};
    return p;
}

/// Vulkan clip space, y down.
inline glm::dmat4 projectionMatrix(const Camera& camera) {
    if (camera.parallelHeight > 0) return parallelProjection(camera);
    const double f = 1 / std::tan(radians(camera.fovDegrees) / 2);
    glm::dmat4 p(0);
    p[0][0] = f * camera.height / camera.width;
    p[1][1] = -f;
    p[2][3] = -1;
    const glm::dvec2 shift = 2.0 * camera.jitter / glm::dvec2(camera.width, camera.height) - camera.offCentre;
    p[2][0] = -shift.x;
    p[2][1] = -shift.y;
    const double n = camera.near;
    if (camera.far == 0) {
        p[2][2] = camera.reversed ? 0 : -1;
        p[3][2] = camera.reversed ? n : -n;
    } else {
        const double z = camera.far;
        p[2][2] = camera.reversed ? n / (z - n) : -z / (z - n);
        p[3][2] = camera.reversed ? n * z / (z - n) : -n * z / (z - n);
    }
    return p;
}

inline void copyMatrix(const glm::dmat4& from, double (&to)[16]) {
    for (int i = 0; i < 16; ++i) to[i] = from[i / 4][i % 4];
}

/// Matrices and viewport; the images are the caller's.
inline seaglass::ViewDesc viewDesc(const Camera& camera) {
    seaglass::ViewDesc view;
    copyMatrix(viewMatrix(camera), view.view);
    copyMatrix(projectionMatrix(camera), view.projection);
    view.viewport = {0, 0, static_cast<float>(camera.width), static_cast<float>(camera.height), 0, 1};
    return view;
}

} // namespace tests
