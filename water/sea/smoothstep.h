// GLSL's smoothstep().
#pragma once

#include <algorithm>

namespace seaglass {

constexpr double smoothstep(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace seaglass
