// What a body covers of its plane: its outline, whichever shape described it.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "gpu/fields.h"
#include "seaglass/water.h"

namespace seaglass {

struct OutlineEdge {
    glm::dvec2 from{0}, to{0}; ///< (u, v) [m]
};

struct OutlineBox {
    glm::dvec2 low{0}, high{0};
    /// As shaders have it.
    glm::vec4 packed() const { return {low, high}; }
};

/// Edges in any order that together close, so that a point is within when a ray from it meets an odd number.
struct Outline {
    std::vector<OutlineEdge> edges;
    glm::dvec2 low{0}, high{0};

    bool contains(const glm::dvec2& point) const;
    double distanceTo(const glm::dvec2& point) const;
    /// The box around it, relative to an eye [m].
    OutlineBox boxFrom(const glm::dvec2& eye) const { return {low - eye, high - eye}; }
};

/// Whether a segment comes into a box.
bool meets(const OutlineEdge& edge, const glm::dvec2& low, const glm::dvec2& high);

/// Of a usable description; no edges where it is unbounded.
Outline outlineOf(const ExtentDesc& desc);

/// The most that the waves of a sea move a point in any axis [m].
double largestDisplacement(const Sea& sea);

/// How near to the outline waves begin to move points less to the side, and on it not at all, so that water
/// stays within its walls and leaves no gap before them [m].
inline double pinnedWithin(double largestDisplacement) {
    return 2 * largestDisplacement;
}

} // namespace seaglass
