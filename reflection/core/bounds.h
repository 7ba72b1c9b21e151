// The box around what mirrors: which views see it, and in which of their pixels, so that of several
// reflectors in a frame each works for its own surface alone.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/view/view.h"

namespace seaglass {

struct Bounds {
    bool everywhere = true;
    glm::dvec3 low{0}, high{0}; ///< along `axes`
    glm::dmat3 axes{1};         ///< in the world
};

/// Null when they are usable, else what is wrong with them.
const char* readBounds(const double (&low)[3], const double (&high)[3], Bounds& out);

/// The pixels of the region that may show it, (x, y) and one past the last (x, y): all of them at most, and
/// none, four zeros, where the view does not see it.
glm::ivec4 pixelsThatMayShow(const Bounds& bounds, const ViewGeometry& view);

inline bool isEmpty(const glm::ivec4& pixels) {
    return pixels.x >= pixels.z || pixels.y >= pixels.w;
}

} // namespace seaglass
