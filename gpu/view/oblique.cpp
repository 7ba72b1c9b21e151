#include "gpu/view/oblique.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace seaglass {

namespace {

/// Of the plain depth's change along a ray, what the oblique depth must change at least. Under a perspective
/// projection that ratio is about the eye's height over the near distance, whatever unit both are in.
constexpr double leastDepthSlope = 1.0 / 64;

void setDepthRow(glm::dmat4& m, const glm::dvec4& row) {
    for (int column = 0; column < 4; ++column) m[column][2] = row[column];
}

} // namespace

ObliqueProjection obliqueProjection(const glm::dmat4& projection, bool reversedDepth, const glm::dvec4& plane,
                                    double farthest) {
    const glm::dvec4 inClip = plane * glm::inverse(projection);
    const glm::dvec4 corner(glm::sign(inClip.x), glm::sign(inClip.y), farthest, 1.0);
    const double greatest = glm::dot(inClip, corner);
    const double growth = reversedDepth ? -inClip.z : inClip.z;
    ObliqueProjection out{projection, false};
    if (!(greatest > 0) || !(growth > leastDepthSlope * greatest)) return out;
    const glm::dvec4 fromNear = plane / greatest;
    const glm::dvec4 weight(projection[0][3], projection[1][3], projection[2][3], projection[3][3]);
    setDepthRow(out.projection, reversedDepth ? weight - fromNear : fromNear);
    out.oblique = true;
    return out;
}

} // namespace seaglass
