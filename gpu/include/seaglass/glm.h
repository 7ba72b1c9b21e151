// GLM's vectors and matrices in and out of plain arrays, of whatever precision and alignment. No other header
// includes it and no library was compiled with it: GLM's macros change the host's own code alone.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "seaglass/host.h"

namespace seaglass {

/// ViewDesc::view and projection: column-major, as GLM's.
template<typename T, glm::qualifier Q>
void assign(double (&out)[16], const glm::mat<4, 4, T, Q>& matrix) {
    for (glm::length_t i = 0; i < 16; ++i) out[i] = static_cast<double>(matrix[i / 4][i % 4]);
}

/// Directions, irradiances, boxes, planes: `N` is float or double.
template<typename N, glm::length_t count, typename T, glm::qualifier Q>
void assign(N (&out)[count], const glm::vec<count, T, Q>& vector) {
    for (glm::length_t i = 0; i < count; ++i) out[i] = static_cast<N>(vector[i]);
}

/// The plane through a point, of a normal of any length: BodyDesc::plane.
template<typename T, glm::qualifier Q>
void assignPlane(double (&out)[4], const glm::vec<3, T, Q>& point, const glm::vec<3, T, Q>& normal) {
    out[3] = 0;
    for (glm::length_t i = 0; i < 3; ++i) {
        out[i] = static_cast<double>(normal[i]);
        out[3] -= out[i] * static_cast<double>(point[i]);
    }
}

/// A camera over the whole of an attachment; the scene's images are left to the host.
template<typename T, glm::qualifier Q>
ViewDesc viewDesc(const glm::mat<4, 4, T, Q>& view, const glm::mat<4, 4, T, Q>& projection,
                  VkExtent2D extent) {
    ViewDesc out;
    assign(out.view, view);
    assign(out.projection, projection);
    out.viewport = {0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    return out;
}

/// Light by a unit `toSun`. The sky is left to the host: its cube or, of no `skyIrradiance`, its colours.
template<typename T, glm::qualifier Q>
LightingDesc lightingDesc(const glm::vec<3, T, Q>& toSun, const glm::vec<3, T, Q>& sunIrradiance,
                          const glm::vec<3, T, Q>& skyIrradiance = glm::vec<3, T, Q>(0)) {
    LightingDesc out;
    assign(out.toSun, toSun);
    assign(out.sunIrradiance, sunIrradiance);
    assign(out.skyIrradiance, skyIrradiance);
    return out;
}

/// The matrices of PlanarView, as `T`: float or double.
template<typename T>
glm::mat<4, 4, T, glm::defaultp> toMat4(const double (&matrix)[16]) {
    glm::mat<4, 4, T, glm::defaultp> out;
    for (glm::length_t i = 0; i < 16; ++i) out[i / 4][i % 4] = static_cast<T>(matrix[i]);
    return out;
}

} // namespace seaglass
