// GLM's vectors and matrices in and out of Seaglass's plain arrays, of whatever precision and alignment the
// host has them. Apart: no other header includes it, nothing in the libraries was compiled with it, and GLM's
// macros change nothing but the host's own code.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "seaglass/host.h"

namespace seaglass {

/// ViewDesc::view and projection: column-major, as GLM's own.
template<typename T, glm::qualifier Q>
void assign(double (&out)[16], const glm::mat<4, 4, T, Q>& matrix) {
    for (glm::length_t i = 0; i < 16; ++i) out[i] = static_cast<double>(matrix[i / 4][i % 4]);
}

/// Directions, irradiances, boxes: `N` is float or double.
template<typename N, typename T, glm::qualifier Q>
void assign(N (&out)[3], const glm::vec<3, T, Q>& vector) {
    for (glm::length_t i = 0; i < 3; ++i) out[i] = static_cast<N>(vector[i]);
}

/// Planes.
template<typename T, glm::qualifier Q>
void assign(double (&out)[4], const glm::vec<4, T, Q>& vector) {
    for (glm::length_t i = 0; i < 4; ++i) out[i] = static_cast<double>(vector[i]);
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

/// A camera over the whole of an attachment, y as the projection has it. The scene's images are to follow.
template<typename T, glm::qualifier Q>
ViewDesc viewDesc(const glm::mat<4, 4, T, Q>& view, const glm::mat<4, 4, T, Q>& projection,
                  VkExtent2D extent) {
    ViewDesc out;
    assign(out.view, view);
    assign(out.projection, projection);
    out.viewport = {0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    return out;
}

/// Light as LightingDesc has it: `toSun` unit. The sky's cube is to follow.
template<typename T, glm::qualifier Q>
LightingDesc lightingDesc(const glm::vec<3, T, Q>& toSun, const glm::vec<3, T, Q>& sunIrradiance,
                          const glm::vec<3, T, Q>& skyIrradiance) {
    LightingDesc out;
    assign(out.toSun, toSun);
    assign(out.sunIrradiance, sunIrradiance);
    assign(out.skyIrradiance, skyIrradiance);
    return out;
}

/// Light under a sky of colours: LightingDesc's own, or the three that are assigned then.
template<typename T, glm::qualifier Q>
LightingDesc lightingDesc(const glm::vec<3, T, Q>& toSun, const glm::vec<3, T, Q>& sunIrradiance) {
    return lightingDesc(toSun, sunIrradiance, glm::vec<3, T, Q>(0));
}

/// The matrices of PlanarView, as `T`: float or double.
template<typename T>
glm::mat<4, 4, T, glm::defaultp> toMat4(const double (&matrix)[16]) {
    glm::mat<4, 4, T, glm::defaultp> out;
    for (glm::length_t i = 0; i < 16; ++i) out[i / 4][i % 4] = static_cast<T>(matrix[i]);
    return out;
}

} // namespace seaglass
