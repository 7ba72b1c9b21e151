// Triangles that lie in one plane, over each other, and face the same way: which of them shows is a matter of
// rounding.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace tests {

struct Face {
    glm::dvec3 corners[3]; ///< [m], anticlockwise from where it is seen
    uint32_t source = 0;   ///< the caller's
};

struct Overlap {
    uint32_t sources[2]; ///< of the two faces
    double area = 0;     ///< [m^2]
    glm::dvec3 at{0};    ///< a corner of it
    glm::dvec3 facing{0};
};

/// All pairs that overlap by more than `area`, nowhere farther apart than `gap` there.
std::vector<Overlap> coplanarOverlaps(const std::vector<Face>& faces, double gap, double area);

} // namespace tests
