#include "water/mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace seaglass {

namespace {

// A flat sea seen from h metres up comes within h/d radians of the horizon at distance d: 1/4000 rad is less
// than a pixel of any display. At least 100 km, so that crests do not end before the horizon does.
// A globe's sea ends before that, where it has sunk below all that is seen of it, its highest crests too.
double horizonDistance(const MeshView& view) {
    const double height = std::abs(view.eyeHeight), flat = std::max(100e3, 4000.0 * height);
    if (view.globe.flat()) return flat;
    return std::min(flat, 1.1 * (view.globe.horizonFrom(height) + view.globe.horizonFrom(view.displacement)));
}

/// Levels that waves get near an eye, below those that a mesh is asked for.
int nearLevels(double displacement, double finestCell) {
    if (displacement == 0) return 0;
    return std::max(static_cast<int>(std::ceil(std::log2(finestCell / nearestCell))), 0);
}

/// Where patches of each level may lie, and which of them a view asks for. Corners are relative to the eye.
struct Lattice {
    const MeshView& view;
    double finestCell; ///< of those that are asked for
    double rangeInCells;
    int near = view.parallel ? 0 : nearLevels(view.displacement, finestCell);
    MeshLattice drawnOn = points();

    double cell(int level) const { return std::ldexp(finestCell, level - near); }
    double edge(int level) const { return cell(level) * patchCells; }
    double range(int level) const { return cell(level) * (level < near ? fewestInRange : rangeInCells); }

    double distanceTo(int level, const glm::dvec2& corner) const {
        if (view.parallel) return view.parallel->distance;
        const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), corner, corner + edge(level));
        return glm::length(glm::dvec3(nearest, view.eyeHeight));
    }

    /// Of what the waves may have moved nearer.
    double leastDistanceTo(int level, const glm::dvec2& corner) const {
        const double moved = view.parallel ? 0 : 2 * view.displacement;
        return std::max(distanceTo(level, corner) - moved, 0.0);
    }

    bool isDivided(int level, const glm::dvec2& corner) const {
        return level > 0 && distanceTo(level, corner) < range(level - 1);
    }

    /// What a cell as wide leaves out of the waves and of the globe [m].
    double lostBetween(double width) const {
        return view.waves->lostBetween(width) + view.globe.bulgeOver(width);
    }

    /// Cells across a patch, so that what they leave out of the waves is not seen. By an outline that holds
    /// the waves: so that what they have there is not.
    uint32_t cellsFor(int level, const glm::dvec2& corner, bool held = false) const {
        if (!view.waves) return patchCells;
        const double unseen = 0.31 * view.pixel * leastDistanceTo(level, corner);
        if (held && view.displacement > unseen) return patchCells;
        uint32_t cells = fewestCells;
        while (cells < patchCells && lostBetween(edge(level) / cells) > unseen) cells *= 2;
        return cells;
    }

    /// The coarsest level whose range is at least `reach`.
    int coarsest(double reach) const {
        int level = 0;
        while (range(level) < reach) ++level;
        return level;
    }

    /// All patches of a level that touch a box around the eye.
    template<typename Visit>
    void forEach(int level, const glm::dvec2& low, const glm::dvec2& high, Visit&& visit) const {
        const glm::dvec2 first = glm::floor((view.eye + low) / edge(level)),
                         last = glm::floor((view.eye + high) / edge(level));
        for (double j = first.y; j <= last.y; ++j)
            for (double i = first.x; i <= last.x; ++i) visit(glm::dvec2(i, j) * edge(level) - view.eye);
    }

    template<typename Visit>
    void forEachChild(int level, const glm::dvec2& corner, Visit&& visit) const {
        for (int child = 0; child < 4; ++child)
            visit(corner + glm::dvec2(child & 1, child >> 1) * edge(level - 1));
    }

    /// Of those that may be drawn: none is nearer than the calm plane.
    int finest() const {
        const double nearest = view.parallel ? view.parallel->distance : std::abs(view.eyeHeight);
        int level = 0;
        while (range(level) < nearest) ++level;
        return level;
    }

    MeshLattice points() const {
        const double width = cell(finest());
        return {width, glm::floor(view.eye / width) * width - view.eye};
    }

    MeshPatch patch(int level, const glm::dvec2& corner) const {
        const glm::dvec2 cells = glm::round((corner - drawnOn.origin) / drawnOn.cell);
        return {{static_cast<int32_t>(cells.x), static_cast<int32_t>(cells.y)},
                static_cast<float>(cell(level)),
                static_cast<float>(range(level))};
    }
};

double distanceTo(const Lattice& lattice, const MeshPatch& patch) {
    const glm::dvec2 middle = lattice.drawnOn.cornerOf(patch) + 0.5 * double{patch.cell} * patchCells;
    const std::optional<ParallelLines>& parallel = lattice.view.parallel;
    return parallel ? glm::dot(parallel->along, middle) : glm::length(middle);
}

void widenCells(MeshPatch& patch, uint32_t cells) {
    patch.cell *= static_cast<float>(patchCells / cells);
}

bool drawnBefore(const Lattice& lattice, const MeshPatch& a, const MeshPatch& b) {
    return lattice.view.farthestFirst ? distanceTo(lattice, a) > distanceTo(lattice, b) : a.cell < b.cell;
}

class Selection {
  public:
    Selection(const Lattice& lattice, std::vector<MeshPatch>& out) : lattice_(lattice), out_(out) {}

    uint32_t run() {
        lattice_.view.parallel ? selectSeen(*lattice_.view.parallel) : selectToHorizon();
        std::stable_sort(out_.begin(), out_.end(),
                         [&](const MeshPatch& a, const MeshPatch& b) { return drawnBefore(lattice_, a, b); });
        for (MeshPatch& patch : out_) widenCells(patch, cells_);
        return cells_;
    }

  private:
    void selectToHorizon() {
        const int coarsest = lattice_.coarsest(horizonDistance(lattice_.view));
        const double reach = lattice_.range(coarsest);
        lattice_.forEach(coarsest, glm::dvec2(-reach), glm::dvec2(reach), [&](const glm::dvec2& corner) {
            if (lattice_.distanceTo(coarsest, corner) <= reach) visit(coarsest, corner);
        });
        for (MeshPatch& patch : out_)
            if (patch.range > 0.99 * reach) patch.range = -patch.range;
    }

    void selectSeen(const ParallelLines& lines) {
        if (lines.seen.low.x > lines.seen.high.x) return; // none
        const double d = lattice_.view.displacement;
        const double across = glm::length(lines.seen.high - lines.seen.low);
        const int coarsest = lattice_.coarsest(std::max(lines.distance, across));
        lattice_.forEach(coarsest, lines.seen.low - d, lines.seen.high + d,
                         [&](const glm::dvec2& corner) { visit(coarsest, corner); });
    }

    void visit(int level, const glm::dvec2& corner) {
        const double d = lattice_.view.displacement;
        if (!inSight(lattice_.view, {corner - d, corner + lattice_.edge(level) + d})) return;
        if (!lattice_.isDivided(level, corner)) {
            cells_ = std::max(cells_, lattice_.cellsFor(level, corner));
            out_.push_back(lattice_.patch(level, corner));
            return;
        }
        // All four, those beyond the finer range too: there they have glided onto this level's lattice.
        lattice_.forEachChild(level, corner, [&](const glm::dvec2& child) { visit(level - 1, child); });
    }

    const Lattice& lattice_;
    std::vector<MeshPatch>& out_;
    uint32_t cells_ = fewestCells; ///< that the patches need so far
};

/// Of what an outline encloses. Each patch that is visited inherits the edges that come near its parent.
class OutlinedSelection {
  public:
    OutlinedSelection(const Lattice& lattice, const Outline& outline, double pinned, OutlinedPatches& out)
        : lattice_(lattice), outline_(outline), pinned_(pinned), out_(out),
          box_(outline.boxFrom(lattice.view.eye)) {}

    uint32_t run() {
        const glm::dvec2 farthest = glm::max(glm::abs(box_.low), glm::abs(box_.high));
        double reach = glm::length(glm::dvec3(farthest, lattice_.view.eyeHeight));
        if (lattice_.view.parallel) reach = std::max(reach, lattice_.view.parallel->distance);
        const int coarsest = lattice_.coarsest(reach);
        std::vector<OutlineEdge> edges;
        for (const auto& [from, to] : outline_.edges)
            edges.push_back({from - lattice_.view.eye, to - lattice_.view.eye});
        lattice_.forEach(coarsest, box_.low, box_.high,
                         [&](const glm::dvec2& corner) { visit(coarsest, corner, edges); });
        std::stable_sort(out_.patches.begin(), out_.patches.end(),
                         [&](const OutlinedPatch& a, const OutlinedPatch& b) {
                             return drawnBefore(lattice_, a.patch, b.patch);
                         });
        for (OutlinedPatch& outlined : out_.patches) widenCells(outlined.patch, cells_);
        return cells_;
    }

  private:
    void visit(int level, const glm::dvec2& corner, const std::vector<OutlineEdge>& candidates) {
        const glm::dvec2 end = corner + lattice_.edge(level);
        const OutlineBox box{glm::max(corner, box_.low), glm::min(end, box_.high)};
        if (box.low.x > box.high.x || box.low.y > box.high.y || !inSight(lattice_.view, box)) return;
        // A little more than what is pinned, so that a patch without edges agrees with its neighbours in
        // floats.
        const double margin = pinned_ * 1.01 + lattice_.cell(level) * 1e-3;
        std::vector<OutlineEdge> near;
        bool crossed = false;
        for (const OutlineEdge& edge : candidates) {
            if (!meets(edge, corner - margin, end + margin)) continue;
            near.push_back(edge);
            crossed = crossed || meets(edge, corner, end);
        }
        if (!crossed && !outline_.contains((corner + end) / 2.0 + lattice_.view.eye)) return;
        if (lattice_.isDivided(level, corner)) {
            lattice_.forEachChild(level, corner,
                                  [&](const glm::dvec2& child) { visit(level - 1, child, near); });
            return;
        }
        cells_ = std::max(cells_, lattice_.cellsFor(level, corner, !near.empty()));
        const auto first = static_cast<uint32_t>(out_.edges.size());
        if (!near.empty()) list(corner, end, margin);
        out_.patches.push_back(
            {lattice_.patch(level, corner), first, static_cast<uint32_t>(out_.edges.size()) - first});
    }

    /// Edges near a patch, and those that a ray from within it towards -u may cross.
    void list(const glm::dvec2& corner, const glm::dvec2& end, double margin) {
        for (const auto& [from, to] : outline_.edges) {
            const glm::dvec2 a = from - lattice_.view.eye, b = to - lattice_.view.eye;
            if (std::max(a.y, b.y) >= corner.y - margin && std::min(a.y, b.y) <= end.y + margin &&
                std::min(a.x, b.x) <= end.x + margin)
                out_.edges.emplace_back(glm::vec2(a), glm::vec2(b));
        }
    }

    const Lattice& lattice_;
    const Outline& outline_;
    double pinned_;
    OutlinedPatches& out_;
    OutlineBox box_;               ///< of the outline, relative to the eye
    uint32_t cells_ = fewestCells; ///< that the patches need so far
};

} // namespace

glm::dvec2 MeshLattice::cornerOf(const MeshPatch& patch) const {
    return origin + glm::dvec2(patch.corner[0], patch.corner[1]) * cell;
}

MeshLattice meshLattice(const MeshView& view, double finestCell, double rangeInCells) {
    return Lattice{view, finestCell, rangeInCells}.drawnOn;
}

double cellNearEye(double displacement, double finestCell) {
    return std::ldexp(finestCell, -nearLevels(displacement, finestCell));
}

std::array<glm::dvec4, 5> frustumPlanes(const glm::dmat4& clip, bool reversedDepth) {
    const glm::dmat4 rows = glm::transpose(clip);
    // Only the near plane bounds depth: seen from an eye the sea goes on to an infinite far plane.
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
            reversedDepth ? rows[3] - rows[2] : rows[2]};
}

bool inSight(const MeshView& view, const OutlineBox& box) {
    const double d = view.displacement;
    const glm::dvec2 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    const double sunk = view.globe.dropAt(glm::dot(farthest, farthest));
    const glm::dvec3 low(box.low.x, -d - sunk, box.low.y), high(box.high.x, d, box.high.y);
    return std::all_of(view.frustum.begin(), view.frustum.end(), [&](const glm::dvec4& plane) {
        const glm::dvec3 normal(plane);
        const glm::dvec3 innermost = glm::mix(low, high, glm::greaterThan(normal, glm::dvec3(0)));
        return glm::dot(normal, innermost) + plane.w >= 0;
    });
}

uint32_t selectPatches(const MeshView& view, double finestCell, double rangeInCells,
                       std::vector<MeshPatch>& out) {
    out.clear();
    const Lattice lattice{view, finestCell, rangeInCells};
    return Selection(lattice, out).run();
}

uint32_t selectPatches(const MeshView& view, double finestCell, double rangeInCells, const Outline& outline,
                       double pinned, OutlinedPatches& out) {
    out.patches.clear();
    out.edges.clear();
    const Lattice lattice{view, finestCell, rangeInCells};
    return OutlinedSelection(lattice, outline, pinned, out).run();
}

std::vector<uint16_t> patchIndices() {
    constexpr uint32_t row = patchCells + 1;
    std::vector<uint16_t> indices;
    indices.reserve(firstPatchIndex(2 * patchCells));
    for (uint32_t cells = fewestCells; cells <= patchCells; cells *= 2)
        for (uint32_t j = 0; j < cells; ++j)
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = j * row + i;
                for (const uint32_t vertex : {a, a + row, a + 1, a + 1, a + row, a + row + 1})
                    indices.push_back(static_cast<uint16_t>(vertex));
            }
    return indices;
}

} // namespace seaglass
