// What water covers of its plane.
#pragma once

#include <limits>
#include <vector>

#include <glm/vec2.hpp>

#include "seaglass/water.h"

namespace demos::reference {

struct Outline {
    struct Edge {
        glm::dvec2 from{0}, to{0}; ///< (u, v) [m]
    };
    std::vector<Edge> edges; ///< in any order: a ray from a point within meets an odd number
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-low};

    bool contains(const glm::dvec2& point) const;
    double distanceTo(const glm::dvec2& point) const;
};

/// Of a usable description that is bounded.
Outline outlineOf(const seaglass::ExtentDesc& desc);

} // namespace demos::reference
