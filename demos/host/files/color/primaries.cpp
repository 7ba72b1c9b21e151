#include "host/files/color/primaries.h"

#include <algorithm>
#include <cmath>

namespace demos {
namespace {

constexpr double leastDeterminant = 1e-6;

/// XYZ of a chromaticity at luminance 1.
glm::dvec3 atUnitLuminance(double x, double y) {
    return {x / y, 1, (1 - x - y) / y};
}

glm::dvec3 whiteOf(const Primaries& p) {
    return atUnitLuminance(p[6], p[7]);
}

/// SMPTE RP 177.
glm::dmat3 xyzFrom(const Primaries& p) {
    const glm::dmat3 ends(p[0], p[1], 1 - p[0] - p[1], p[2], p[3], 1 - p[2] - p[3], p[4], p[5],
                          1 - p[4] - p[5]);
    const glm::dvec3 amounts = glm::inverse(ends) * whiteOf(p);
    return {ends[0] * amounts[0], ends[1] * amounts[1], ends[2] * amounts[2]};
}

glm::dmat3 adapted(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dmat3 cones(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
    const glm::dvec3 ratio = (cones * to) / (cones * from);
    return glm::inverse(cones) * glm::dmat3(ratio.x, 0, 0, 0, ratio.y, 0, 0, 0, ratio.z) * cones;
}

bool finite(const glm::dmat3& m) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!std::isfinite(m[i][j])) return false;
    return true;
}

} // namespace

std::optional<glm::dmat3> rec709From(const Primaries& p) {
    const bool same = std::equal(p.begin(), p.end(), rec709.begin(),
                                 [](double a, double b) { return std::abs(a - b) < 1e-4; });
    if (same) return glm::dmat3(1);
    const glm::dmat3 matrix =
        glm::inverse(xyzFrom(rec709)) * adapted(whiteOf(p), whiteOf(rec709)) * xyzFrom(p);
    if (!finite(matrix) || std::abs(glm::determinant(matrix)) < leastDeterminant) return std::nullopt;
    return matrix;
}

} // namespace demos
