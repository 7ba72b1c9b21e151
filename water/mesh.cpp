#include "water/mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace seaglass {

namespace {

// A flat sea seen from h metres up comes within h/d radians of the horizon at distance d: 1/4000 rad is less
// than a pixel of any display. At least 100 km, so that crests do not end before the horizon does.
double horizonDistance(double eyeHeight) {
    return std::max(100e3, 4000.0 * std::abs(eyeHeight));
}

class Selection {
  public:
    Selection(const MeshView& view, double finestCell, double rangeInCells, std::vector<MeshPatch>& out)
        : view_(view), finestCell_(finestCell), rangeInCells_(rangeInCells), out_(out) {}

    void run() {
        int coarsest = 0;
        while (range(coarsest) < horizonDistance(view_.eyeHeight)) ++coarsest;
        const double edge = cell(coarsest) * patchCells;
        const double reach = range(coarsest);
        const auto first = [&](double eye) { return std::floor((eye - reach) / edge); };
        const auto last = [&](double eye) { return std::floor((eye + reach) / edge); };
        for (double j = first(view_.eye.y); j <= last(view_.eye.y); ++j)
            for (double i = first(view_.eye.x); i <= last(view_.eye.x); ++i)
                visit(coarsest, glm::dvec2(i, j) * edge - view_.eye, reach);
        std::stable_sort(out_.begin(), out_.end(),
                         [](const MeshPatch& a, const MeshPatch& b) { return a.cell < b.cell; });
    }

  private:
    double cell(int level) const { return std::ldexp(finestCell_, level); }
    double range(int level) const { return cell(level) * rangeInCells_; }

    double distanceTo(const glm::dvec2& corner, double edge) const {
        const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), corner, corner + edge);
        return glm::length(glm::dvec3(nearest, view_.eyeHeight));
    }

    bool inSight(const glm::dvec2& corner, double edge) const {
        const double d = view_.displacement;
        const glm::dvec3 low(corner.x - d, -d, corner.y - d);
        const glm::dvec3 high(corner.x + edge + d, d, corner.y + edge + d);
        return std::all_of(view_.frustum.begin(), view_.frustum.end(), [&](const glm::dvec4& plane) {
            const glm::dvec3 normal(plane);
            const glm::dvec3 farthest = glm::mix(low, high, glm::greaterThan(normal, glm::dvec3(0)));
            return glm::dot(normal, farthest) + plane.w >= 0;
        });
    }

    void visit(int level, const glm::dvec2& corner, double reach) {
        const double edge = cell(level) * patchCells;
        if (distanceTo(corner, edge) > reach || !inSight(corner, edge)) return;
        if (level > 0 && distanceTo(corner, edge) < range(level - 1)) {
            // All four, those beyond the finer range too: there they have glided onto this level's lattice.
            for (int child = 0; child < 4; ++child)
                visit(level - 1, corner + glm::dvec2(child & 1, child >> 1) * (edge / 2),
                      std::numeric_limits<double>::infinity());
            return;
        }
        out_.push_back({{static_cast<float>(corner.x), static_cast<float>(corner.y)},
                        static_cast<float>(cell(level)),
                        static_cast<float>(range(level))});
    }

    const MeshView& view_;
    double finestCell_;
    double rangeInCells_;
    std::vector<MeshPatch>& out_;
};

} // namespace

std::array<glm::dvec4, 5> frustumPlanes(const glm::dmat4& clip, bool reversedDepth) {
    const glm::dmat4 rows = glm::transpose(clip);
    // Only the near plane bounds depth: the sea goes on to an infinite far plane.
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
            reversedDepth ? rows[3] - rows[2] : rows[2]};
}

void selectPatches(const MeshView& view, double finestCell, double rangeInCells,
                   std::vector<MeshPatch>& out) {
    out.clear();
    Selection(view, finestCell, rangeInCells, out).run();
}

std::vector<uint16_t> patchIndices() {
    constexpr uint32_t row = patchCells + 1;
    std::vector<uint16_t> indices;
    indices.reserve(patchCells * patchCells * 6);
    for (uint32_t j = 0; j < patchCells; ++j)
        for (uint32_t i = 0; i < patchCells; ++i) {
            const uint32_t a = j * row + i;
            for (const uint32_t vertex : {a, a + row, a + 1, a + 1, a + row, a + row + 1})
                indices.push_back(static_cast<uint16_t>(vertex));
        }
    return indices;
}

} // namespace seaglass
