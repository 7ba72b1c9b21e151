// What a body covers: its outline, the patches that are drawn of it, and a mesh of the host's own.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/mesh_support.h"
#include "water/body/exclusion_volumes.h"
#include "water/interface/checks.h"
#include "water/mesh/extent.h"
#include "water/mesh/host_mesh.h"
#include "water/mesh/mesh.h"

namespace {

using namespace seaglass;
using tests::allAround;

constexpr double cell = 0.25;
constexpr double range = 128;

ExtentDesc rectangle(double width, double length, double yaw = 0) {
    ExtentDesc desc;
    desc.shape = ExtentShape::rectangle;
    desc.size[0] = width;
    desc.size[1] = length;
    desc.yaw = yaw;
    return desc;
}

ExtentDesc polygon(const std::vector<double>& points) {
    ExtentDesc desc;
    desc.shape = ExtentShape::polygon;
    desc.points = points.data();
    desc.pointCount = static_cast<uint32_t>(points.size() / 2);
    return desc;
}

ExtentDesc mesh(const std::vector<double>& points, const std::vector<uint32_t>& indices) {
    ExtentDesc desc = polygon(points);
    desc.shape = ExtentShape::mesh;
    desc.indices = indices.data();
    desc.indexCount = static_cast<uint32_t>(indices.size());
    return desc;
}

/// A lake with a bay: no convex shape.
const std::vector<double> lake = {-60, -40, 55, -52, 70, 10, 20, 5, 24, 48, -10, 30, -52, 44};

/// A square of `cells` x `cells` squares of a metre, each cut in two.
struct Grid {
    std::vector<double> points;
    std::vector<uint32_t> indices;

    explicit Grid(uint32_t cells) {
        for (uint32_t j = 0; j <= cells; ++j)
            for (uint32_t i = 0; i <= cells; ++i) points.insert(points.end(), {double(i), double(j)});
        const uint32_t row = cells + 1;
        for (uint32_t j = 0; j < cells; ++j)
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = j * row + i;
                indices.insert(indices.end(), {a, a + row, a + 1, a + 1, a + row, a + row + 1});
            }
    }
};

TEST(Extent, ARectangleTurnsFromXTowardsZ) {
    ExtentDesc desc = rectangle(10, 2, 0.5);
    desc.center[0] = 100;
    const Outline outline = outlineOf(desc);
    const glm::dvec2 center(100, 0), along(std::cos(0.5), std::sin(0.5));
    EXPECT_TRUE(outline.contains(center + along * 4.99));
    EXPECT_TRUE(outline.contains(center - along * 4.99));
    EXPECT_FALSE(outline.contains(center + along * 5.01));
    EXPECT_FALSE(outline.contains(center + glm::dvec2(along.x, -along.y) * 4.9));
    EXPECT_NEAR(outline.distanceTo(center), 1, 1e-12);
    EXPECT_NEAR(outline.distanceTo(center + along * 8.0), 3, 1e-12);
}

TEST(Extent, AMeshIsBoundedByEdgesOfOneTriangle) {
    const Grid grid(4);
    const Outline outline = outlineOf(mesh(grid.points, grid.indices));
    EXPECT_EQ(outline.edges.size(), 16u);
    EXPECT_TRUE(outline.contains({3.9, 0.1}));
    EXPECT_FALSE(outline.contains({4.1, 0.1}));
    EXPECT_EQ(outline.low, glm::dvec2(0));
    EXPECT_EQ(outline.high, glm::dvec2(4));
}

TEST(Extent, WindingDoesNotMatter) {
    std::vector<double> turned;
    for (size_t i = lake.size(); i > 0; i -= 2) turned.insert(turned.end(), {lake[i - 2], lake[i - 1]});
    ASSERT_STREQ(badField(polygon(turned)).text(), "");
    const Outline a = outlineOf(polygon(lake)), b = outlineOf(polygon(turned));
    for (double x = -80; x < 80; x += 3.7)
        for (double z = -60; z < 60; z += 3.1) EXPECT_EQ(a.contains({x, z}), b.contains({x, z}));
}

/// As shaders/water/mesh/extent.glsl does it.
bool isWithin(const OutlinedPatches& drawn, const OutlinedPatch& patch, const glm::vec2& p) {
    bool within = patch.edgeCount == 0;
    for (uint32_t i = patch.firstEdge; i < patch.firstEdge + patch.edgeCount; ++i) {
        const glm::vec4 e = drawn.edges[i];
        if ((e.y <= p.y) != (e.w <= p.y) && e.x + (p.y - e.y) / (e.w - e.y) * (e.z - e.x) < p.x)
            within = !within;
    }
    return within;
}

double nearest(const OutlinedPatches& drawn, const OutlinedPatch& patch, const glm::dvec2& p) {
    Outline near;
    for (uint32_t i = patch.firstEdge; i < patch.firstEdge + patch.edgeCount; ++i) {
        const glm::dvec4 e(drawn.edges[i]);
        near.edges.push_back({{e.x, e.y}, {e.z, e.w}});
    }
    return near.distanceTo(p);
}

TEST(Extent, PatchesCoverWhatTheOutlineEnclosesExactlyOnce) {
    constexpr double pinned = 1.5;
    for (const ExtentDesc& desc : {rectangle(50, 20, 0.3), polygon(lake), rectangle(0.5, 3000, 1)})
        for (const double height : {0.3, 40.0, 5000.0})
            for (const glm::dvec2 eye : {glm::dvec2(3.1, -7.7), glm::dvec2(400, -130)}) {
                const Outline outline = outlineOf(desc);
                OutlinedPatches drawn;
                selectPatches(allAround(eye, height), cell, range, outline, pinned, drawn);
                const MeshLattice lattice = meshLattice(allAround(eye, height), cell, range);
                for (double x = -81; x < 81; x += 1.93)
                    for (double z = -61; z < 61; z += 1.71) {
                        int cover = 0;
                        for (const OutlinedPatch& p : drawn.patches) {
                            const double edge = double{p.patch.cell} * patchCells;
                            const glm::dvec2 at = glm::dvec2(x, z) - eye, corner = lattice.cornerOf(p.patch);
                            if (at.x < corner.x || at.x >= corner.x + edge || at.y < corner.y ||
                                at.y >= corner.y + edge)
                                continue;
                            cover += isWithin(drawn, p, glm::vec2(at));
                            const double truth = outline.distanceTo({x, z});
                            if (truth < pinned)
                                EXPECT_NEAR(nearest(drawn, p, at), truth, 1e-3);
                            else
                                EXPECT_GE(nearest(drawn, p, at), pinned * 0.999);
                        }
                        if (outline.distanceTo({x, z}) < 1e-3) continue;
                        ASSERT_EQ(cover, outline.contains({x, z})) << x << " " << z << " height " << height;
                    }
            }
}

TEST(Extent, FewPatchesLieBesideTheOutline) {
    const Outline outline = outlineOf(rectangle(25, 12));
    OutlinedPatches drawn;
    selectPatches(allAround({3, 30}, 2), cell, range, outline, 0, drawn);
    // 4 m each near the eye: 7 x 4 of them, or 8 x 5, touch it.
    EXPECT_LE(drawn.patches.size(), 40u);
    selectPatches(allAround({3, 3e5}, 2), cell, range, outline, 0, drawn);
    EXPECT_LE(drawn.patches.size(), 4u);
}

TEST(Extent, NothingIsDrawnOfWhatIsOutOfSight) {
    MeshView view = allAround({0, 100}, 2);
    view.frustum[0] = {0, 0, 1, -10}; // what lies more than 10 m ahead of the eye along +v
    OutlinedPatches drawn;
    selectPatches(view, cell, range, outlineOf(rectangle(25, 12)), 0, drawn);
    EXPECT_TRUE(drawn.patches.empty());
    EXPECT_TRUE(drawn.edges.empty());
}

TEST(Extent, HostVerticesKnowTheirCellsAndTheWayToTheBorder) {
    const Grid grid(8);
    const std::vector<HostVertex> vertices = hostVertices(mesh(grid.points, grid.indices), {4, 4});
    for (const HostVertex& v : vertices) {
        const double border = 4 - std::max(std::abs(v.calm[0]), std::abs(v.calm[1]));
        EXPECT_NEAR(v.fromEdge, border, 1e-5);
        EXPECT_GE(v.cell, 1);
        EXPECT_LE(v.cell, 1.42f);
    }
}

// By which patches that no boat is in are drawn without a test for boats.
TEST(Extent, VolumesMayCutTheBoxesThatTheyReachInto) {
    const ExclusionVolume around = {
        {{1, 0, 0, -4}, {-1, 0, 0, 2}, {0, 0, 2, -2}, {0, 0, -1, -1}, {0, -1, 0, -2}}};
    std::vector<ExclusionPlanes> volumes;
    ASSERT_EQ(readExclusionVolumes(&around, 1, volumes), nullptr); // x 2 to 4, z -1 to 1, from 2 m down on
    EXPECT_TRUE(mayExcludeIn(volumes, {-9, -1, -9}, {9, 1, 9}));
    EXPECT_TRUE(mayExcludeIn(volumes, {3, 0, 0}, {3, 0, 0}));
    EXPECT_TRUE(mayExcludeIn(volumes, {0, -1, 0.9}, {2.1, 1, 3}));
    EXPECT_FALSE(mayExcludeIn(volumes, {0, -1, -1}, {1.9, 1, 1}));
    EXPECT_FALSE(mayExcludeIn(volumes, {4.1, -1, -1}, {9, 1, 1}));
    EXPECT_FALSE(mayExcludeIn(volumes, {2, -1, 1.1}, {4, 1, 3}));
    EXPECT_FALSE(mayExcludeIn(volumes, {2, -4, -1}, {4, -2.1, 1}));
    EXPECT_FALSE(mayExcludeIn({}, {-9, -1, -9}, {9, 1, 9}));
}

TEST(Extent, BadFieldsAreNamed) {
    const auto says = [](const ExtentDesc& desc, const char* what) {
        const FieldError bad = badField(desc);
        EXPECT_TRUE(std::strstr(bad.text(), what)) << bad.text() << ", expected " << what;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_STREQ(badField(ExtentDesc{}).text(), "");
    EXPECT_STREQ(badField(rectangle(25, 12)).text(), "");
    EXPECT_STREQ(badField(polygon(lake)).text(), "");
    says(rectangle(0, 12), "extent.size");
    says(rectangle(25, nan), "extent.size");
    says(rectangle(25, 12, nan), "extent.yaw");
    ExtentDesc desc = rectangle(25, 12);
    desc.center[1] = INFINITY;
    says(desc, "extent.center");
    desc = {};
    desc.shape = static_cast<ExtentShape>(9);
    says(desc, "extent.shape");
    desc.shape = ExtentShape::polygon;
    says(desc, "extent.points is null");
    says(polygon({0, 0, 1, 1}), "extent.pointCount");
    says(polygon(std::vector<double>(2 * 1025)), "extent.pointCount");
    says(polygon({0, 0, 1, nan, 1, 1}), "extent.points are not finite");
    says(polygon({0, 0, 0, 0, 1, 0, 1, 1}), "twice");
    says(polygon({0, 0, 1, 1, 1, 0, 0, 1}), "crosses");
    says(polygon({0, 0, 2, 0, 1, 0}), "crosses");             // back along itself
    says(polygon({0, 0, 4, 0, 4, 4, 2, 0, 0, 4}), "crosses"); // a corner on an edge
    const Grid grid(2);
    EXPECT_STREQ(badField(mesh(grid.points, grid.indices)).text(), "");
    says(mesh(grid.points, {}), "extent.indices");
    says(mesh(grid.points, {0, 1}), "extent.indexCount");
    says(mesh(grid.points, {0, 1, 99}), "extent.indices name");
    says(mesh(grid.points, {0, 1, 2}), "area");
    says(mesh({0, 0, 1, 0}, {0, 1, 1}), "extent.pointCount");
}

} // namespace
