#include "gpu/view/plane.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace seaglass {

const char* readPlane(const double (&plane)[4], glm::dvec4& out) {
    for (const double value : plane)
        if (!std::isfinite(value)) return "plane is not finite";
    const glm::dvec4 p(plane[0], plane[1], plane[2], plane[3]);
    const double length = glm::length(glm::dvec3(p));
    if (!(length > 1e-12)) return "plane has no normal: its first three numbers are zero";
    out = p / length;
    return nullptr;
}

} // namespace seaglass
