#include "water/spray/spray_lattice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "water/body/parallel_view.h"
#include "water/interface/wrapped_cell.h"

namespace seaglass {

namespace {

constexpr double highestSpray = 4; ///< over the crests [m]
/// Of a level's square of twice its reach, what a view 60 degrees wide sees at the most.
constexpr double shareSeen = 0.29;

/// Of the view, cut off at `reach` in front of the eye.
ViewCorners cornersTo(const ViewGeometry& view, double reach) {
    ViewCorners corners{};
    const double nearDepth = view.reversedDepth ? 1 : 0;
    for (size_t i = 0; i < 4; ++i) {
        const glm::dvec2 pixel = glm::dvec2(i & 1, i >> 1) * glm::dvec2(view.regionSize);
        const glm::dvec4 p = view.relativeFromPixel * glm::dvec4(pixel, nearDepth, 1);
        const glm::dvec3 along = glm::dvec3(p) / p.w;
        corners[i + 4] = along * (reach / std::max(glm::dot(along, view.forward), 1e-9));
    }
    return corners;
}

std::optional<OutlineBox> seen(const SprayView& view, double reach) {
    const double low = -view.eyeHeight - view.displacement;
    const double high = -view.eyeHeight + view.displacement + highestSpray;
    OutlineBox box;
    if (const auto lines = parallelLines(view.geometry, view.eyeHeight, view.displacement)) {
        if (lines->distance > reach) return std::nullopt;
        box = lines->seen;
    } else {
        box = boxBetween(cornersTo(view.geometry, reach), low, high);
    }
    const double margin = std::min(view.drift, reach / 4);
    box.low = glm::max(box.low - margin, glm::dvec2(-reach));
    box.high = glm::min(box.high + margin, glm::dvec2(reach));
    if (!(box.low.x < box.high.x && box.low.y < box.high.y)) return std::nullopt;
    return box;
}

} // namespace

SprayLattice sprayLattice(const SprayView& view, uint32_t particles) {
    SprayLattice lattice;
    const double across = std::sqrt(particles / (sprayLevels * 4 * shareSeen));
    const glm::dvec2 eye(view.geometry.eye.x, view.geometry.eye.z);
    for (size_t i = 0; i < lattice.levels.size(); ++i) {
        SprayLevel& level = lattice.levels[i];
        level.cell = std::ldexp(finestSprayCell, static_cast<int>(i));
        level.reach = level.cell * across;
        const std::optional<OutlineBox> box = seen(view, level.reach);
        if (!box) continue;
        const glm::dvec2 first = glm::floor((eye + box->low) / level.cell);
        const glm::dvec2 cells = glm::ceil((eye + box->high) / level.cell) - first;
        if (!(cells.x * cells.y <= particles - lattice.count)) {
            // What is seen farther away would be cut off at an edge.
            std::fill(lattice.levels.begin() + static_cast<ptrdiff_t>(i), lattice.levels.end(), SprayLevel());
            break;
        }
        level.first = first;
        level.alongU = static_cast<uint32_t>(cells.x);
        level.alongV = static_cast<uint32_t>(cells.y);
        lattice.count += level.count();
    }
    return lattice;
}

void SprayLattice::fill(const glm::dvec3& eye, SprayBlock& block) const {
    uint32_t first = 0;
    for (size_t i = 0; i < levels.size(); ++i) {
        const SprayLevel& level = levels[i];
        block.cells[i] = {wrappedCell(level.first.x), wrappedCell(level.first.y),
                          static_cast<int32_t>(std::max(level.alongU, 1u)), static_cast<int32_t>(first)};
        block.places[i] = {level.first.x * level.cell - eye.x, level.first.y * level.cell - eye.z, level.cell,
                           level.reach};
        first += level.count();
    }
}

} // namespace seaglass
