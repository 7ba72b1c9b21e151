// GLM's vectors and matrices in and out of Seaglass's plain arrays, of whatever precision and alignment the
// host has them. Apart: no other header includes it, nothing in the libraries was compiled with it, and GLM's
// macros change nothing but the host's own code.
#ifndef SEAGLASS_GLM_H
#define SEAGLASS_GLM_H

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

/// The matrices of PlanarView, as `T`: float or double.
template<typename T>
glm::mat<4, 4, T, glm::defaultp> toMat4(const double (&matrix)[16]) {
    glm::mat<4, 4, T, glm::defaultp> out;
    for (glm::length_t i = 0; i < 16; ++i) out[i / 4][i % 4] = static_cast<T>(matrix[i]);
    return out;
}

} // namespace seaglass

#endif
