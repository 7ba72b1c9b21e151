#include "water/body/parallel_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace seaglass {

namespace {

/// The height that such an eye sees, of its distance: 2 tan 22.5 degrees.
constexpr double heightOfDistance = 0.828;
/// A view along the plane sees it endlessly far, and no more patches of it than this on end.
constexpr double mostPatches = 128, patchesOfDistance = 8;

/// Of a metre: flatter lines meet water far from where they begin.
constexpr double leastSinking = 0.05;

/// Relative to the eye. (x, y): 0 and 1 at the region's borders; z: 0 on the near plane, 1 on the far one.
glm::dvec3 inView(const ViewGeometry& view, const glm::dvec3& at) {
    const double depth = view.reversedDepth ? 1 - at.z : at.z;
    const glm::dvec2 pixel = glm::dvec2(at) * glm::dvec2(view.regionSize);
    const glm::dvec4 p = view.relativeFromPixel * glm::dvec4(pixel, depth, 1);
    return glm::dvec3(p) / p.w;
}

double distanceOf(const ViewGeometry& view) {
    const double metresPerPixel = 1 / glm::length(glm::dvec3(row(view.pixelFromRelative, 1)));
    return metresPerPixel * view.regionSize.y / heightOfDistance;
}

/// Around what of the edge from `a` to `b` lies from `low` to `high`.
void addWithin(const glm::dvec3& a, const glm::dvec3& b, double low, double high, OutlineBox& box) {
    double first = 0, last = 1;
    const double rise = b.y - a.y;
    if (std::abs(rise) > 1e-12) {
        const double atLow = (low - a.y) / rise, atHigh = (high - a.y) / rise;
        first = std::max(first, std::min(atLow, atHigh));
        last = std::min(last, std::max(atLow, atHigh));
    } else if (a.y < low || a.y > high)
        return;
    if (first > last) return;
    for (const double share : {first, last}) {
        const glm::dvec3 p = glm::mix(a, b, share);
        box.low = glm::min(box.low, glm::dvec2(p.x, p.z));
        box.high = glm::max(box.high, glm::dvec2(p.x, p.z));
    }
}

ViewCorners cornersOf(const ViewGeometry& view) {
    ViewCorners corners{};
    for (size_t i = 0; i < corners.size(); ++i)
        corners[i] = inView(view, glm::dvec3(i & 1, i >> 1 & 1, i >> 2));
    return corners;
}

} // namespace

OutlineBox boxBetween(const ViewCorners& corners, double low, double high) {
    constexpr double most = std::numeric_limits<double>::max();
    OutlineBox box{glm::dvec2(most), glm::dvec2(-most)};
    for (size_t corner = 0; corner < corners.size(); ++corner)
        for (const size_t axis : {1u, 2u, 4u})
            if (!(corner & axis)) addWithin(corners[corner], corners[corner | axis], low, high, box);
    return box;
}

void placeEye(ViewGeometry& view, double level) {
    if (!view.parallel) return;
    glm::dvec3 moved = inView(view, {0.5, 0.5, 0});
    // A bed's near plane is the water itself, and seen from above it, if it rounds to below.
    const double height = view.eye.y + moved.y - level, distance = distanceOf(view);
    if (height > -1e-6 * distance && view.sight.y < 0)
        moved += view.sight * (height / std::max(-view.sight.y, leastSinking) - distance);
    const glm::dmat4 back = glm::translate(glm::dmat4(1), moved);
    view.eye += moved;
    view.clipFromRelative = view.clipFromRelative * back;
    view.pixelFromRelative = view.pixelFromRelative * back;
    view.relativeFromPixel = glm::translate(glm::dmat4(1), -moved) * view.relativeFromPixel;
}

std::optional<ParallelLines> parallelLines(const ViewGeometry& view, double eyeHeight, double displacement) {
    if (!view.parallel) return std::nullopt;
    ParallelLines lines;
    lines.along = {view.sight.x, view.sight.z};
    lines.seen = boxBetween(cornersOf(view), -eyeHeight - displacement, -eyeHeight + displacement);
    const glm::dvec2 size = glm::max(lines.seen.high - lines.seen.low, glm::dvec2(0));
    const double least = std::max(size.x, size.y) * patchesOfDistance / mostPatches;
    lines.distance = std::max(distanceOf(view), least);
    return lines;
}

} // namespace seaglass
