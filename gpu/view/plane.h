// A plane as a host describes it: n.p + d = 0.
#pragma once

#include <glm/vec4.hpp>

namespace seaglass {

/// Null when the plane is usable, else what is wrong. `out` has a unit normal.
const char* readPlane(const double (&plane)[4], glm::dvec4& out);

} // namespace seaglass
