// What stands for the eye that a view with parallel lines of sight has not: a place on its middle line, to
// which all is relative, and a distance at which such an eye would see the mesh's cells as large.
#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gpu/view/view.h"
#include "water/mesh/extent.h"

namespace seaglass {

/// What a mesh is told of such a view.
struct ParallelLines {
    glm::dvec2 along{0}; ///< their direction over (u, v), shorter the steeper they are
    /// From where an eye would see cells as large [m]: one whose field of view of 45 degrees is as high
    /// there.
    double distance = 0;
    OutlineBox seen; ///< of the water, relative to the eye
};

/// Of a view's near plane, then of its end; the lowest bit is right, the next down.
using ViewCorners = std::array<glm::dvec3, 8>;

/// Around what lies in a view between two heights, as its corners are given: all corners of that lie on the
/// view's edges. Low is above high where nothing does.
OutlineBox boxBetween(const ViewCorners& corners, double low, double high);

/// Moves the eye along the middle line, to before what it sees of a plane at `level`, and to the near plane
/// where lines begin below it: hosts have such eyes anywhere, and floats are coarse far from them. Of other
/// views nothing.
void placeEye(ViewGeometry& view, double level);

/// None where the lines come from an eye. `eyeHeight`: above the calm plane; `displacement`: what waves move
/// it by, at the most [m].
std::optional<ParallelLines> parallelLines(const ViewGeometry& view, double eyeHeight, double displacement);

} // namespace seaglass
