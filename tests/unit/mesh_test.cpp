// The surface's mesh: it must cover the sea to the horizon once, and fit together where levels meet.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/cameras.h"
#include "tests/unit/mesh_support.h"
#include "water/mesh.h"

namespace {

using namespace seaglass;
using tests::allAround;

constexpr double cell = 0.25;
constexpr double range = 128;

std::vector<MeshPatch> patchesFor(const MeshView& view) {
    std::vector<MeshPatch> patches;
    selectPatches(view, cell, range, patches);
    return patches;
}

/// How many patches hold a point.
int cover(const std::vector<MeshPatch>& patches, double u, double v) {
    return static_cast<int>(std::count_if(patches.begin(), patches.end(), [&](const MeshPatch& p) {
        const double edge = double{p.cell} * patchCells;
        return u >= p.corner[0] && u < p.corner[0] + edge && v >= p.corner[1] && v < p.corner[1] + edge;
    }));
}

TEST(Mesh, CoversThePlaneExactlyOnce) {
    for (const double height : {0.001, 2.0, 300.0, 1e5}) {
        const std::vector<MeshPatch> patches = patchesFor(allAround({3.1, -7.7}, height));
        const double reach = std::max(100e3, 4000 * height) * 0.7;
        for (double r = 0.37; r < reach; r *= 1.9)
            for (double angle = 0.1; angle < 6.2; angle += 0.61)
                EXPECT_EQ(cover(patches, r * std::cos(angle), r * std::sin(angle)), 1)
                    << "height " << height << " r " << r << " angle " << angle;
    }
}

TEST(Mesh, SaysWhichPatchesTheSeaEndsWith) {
    for (const double height : {2.0, 1e5}) {
        const std::vector<MeshPatch> patches = patchesFor(allAround({3.1, -7.7}, height));
        const auto wider = [](const MeshPatch& a, const MeshPatch& b) { return a.cell < b.cell; };
        const float coarsest = std::max_element(patches.begin(), patches.end(), wider)->cell;
        for (const MeshPatch& p : patches) EXPECT_EQ(p.range < 0, p.cell == coarsest);
    }
}

TEST(Mesh, VerticesStayWhereTheyAreWhenTheEyeMoves) {
    // Relative corners plus the eye are multiples of the patch's edge.
    const glm::dvec2 eye(1234.567, -98.76);
    for (const MeshPatch& p : patchesFor(allAround(eye, 2))) {
        if (double{p.cell} * range > 2000) continue; // beyond, a float corner rounds to centimetres
        const double edge = double{p.cell} * patchCells;
        const double lattice = (p.corner[0] + eye.x) / edge;
        EXPECT_NEAR(lattice, std::round(lattice), 1e-3);
    }
}

double glide(const MeshPatch& p, double distance) {
    return std::clamp((distance / std::abs(double{p.range}) - 0.7) / (0.95 - 0.7), 0.0, 1.0);
}

TEST(Mesh, LevelsMeetWithoutCracks) {
    // Where a fine patch touches a coarser one its vertices must have glided fully, the coarser one's not at
    // all.
    for (const double height : {0.5, 10.0, 77.0}) {
        const MeshView view = allAround({11.3, 4.9}, height);
        const std::vector<MeshPatch> patches = patchesFor(view);
        const double end = 3000;
        int seams = 0;
        for (const MeshPatch& fine : patches)
            for (const MeshPatch& coarse : patches) {
                if (coarse.cell <= fine.cell || std::abs(fine.corner[0]) > end ||
                    std::abs(fine.corner[1]) > end)
                    continue;
                const double edge = double{fine.cell} * patchCells;
                const double coarseEdge = double{coarse.cell} * patchCells;
                for (uint32_t i = 0; i <= patchCells; ++i) {
                    const glm::dvec2 p(fine.corner[0] + edge, fine.corner[1] + i * double{fine.cell});
                    const bool shared = std::abs(p.x - coarse.corner[0]) < 1e-6 &&
                                        p.y >= coarse.corner[1] - 1e-6 &&
                                        p.y <= coarse.corner[1] + coarseEdge + 1e-6;
                    if (!shared) continue;
                    ++seams;
                    const double distance = glm::length(glm::dvec3(p, height));
                    EXPECT_EQ(coarse.cell, 2 * fine.cell);
                    EXPECT_EQ(glide(fine, distance), 1);
                    EXPECT_EQ(glide(coarse, distance), 0);
                }
            }
        EXPECT_GT(seams, 0);
    }
}

TEST(Mesh, LeavesOutWhatIsBehindTheEye) {
    tests::Camera camera;
    camera.eye = {0, 2, 0};
    camera.target = {0, 2, -10};
    glm::dmat4 rotation = tests::viewMatrix(camera);
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    glm::dmat4 fromFoot(1);
    fromFoot[3].y = -2;
    MeshView view = allAround({0, 0}, 2);
    const size_t all = patchesFor(view).size();
    view.frustum = frustumPlanes(tests::projectionMatrix(camera) * rotation * fromFoot, true);
    const std::vector<MeshPatch> seen = patchesFor(view);
    EXPECT_LT(seen.size(), all / 2);
    EXPECT_EQ(cover(seen, 0.1, 50), 0);
    EXPECT_EQ(cover(seen, 0.1, -50), 1);
    EXPECT_EQ(cover(seen, 0.1, -50e3), 1);
}

TEST(Mesh, IndicesUseEveryVertexAndNoOther) {
    const std::vector<uint16_t> indices = patchIndices();
    const std::set<uint16_t> used(indices.begin(), indices.end());
    EXPECT_EQ(indices.size(), patchCells * patchCells * 6);
    EXPECT_EQ(used.size(), (patchCells + 1) * (patchCells + 1));
    EXPECT_EQ(*used.rbegin(), (patchCells + 1) * (patchCells + 1) - 1);
}

} // namespace
