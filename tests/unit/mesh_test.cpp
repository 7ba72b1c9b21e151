// The surface's mesh: it must cover the sea to the horizon once, and fit together where levels meet.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/unit/cameras.h"
#include "tests/unit/mesh_support.h"
#include "water/body/parallel_view.h"
#include "water/mesh/mesh.h"
#include "water/mesh/placing.h"

namespace {

using namespace seaglass;
using tests::allAround;
using tests::placed;
using tests::PlacedPatch;

constexpr double cell = 0.25;
constexpr double range = 128;

struct Selected {
    std::vector<PlacedPatch> patches;
    uint32_t cells;
};

Selected select(const MeshView& view, double rangeInCells = range) {
    std::vector<MeshPatch> patches;
    Selected selected{{}, selectPatches(view, cell, rangeInCells, patches)};
    const MeshLattice lattice = meshLattice(view, cell, rangeInCells);
    for (const MeshPatch& patch : patches) selected.patches.push_back(placed(lattice, patch));
    return selected;
}

std::vector<PlacedPatch> patchesFor(const MeshView& view, double rangeInCells = range) {
    return select(view, rangeInCells).patches;
}

MeshView withWaves(MeshView view) {
    view.displacement = 0.4;
    return view;
}

/// How many patches hold a point.
int cover(const std::vector<PlacedPatch>& patches, double u, double v) {
    return static_cast<int>(std::count_if(patches.begin(), patches.end(), [&](const PlacedPatch& p) {
        const double edge = double{p.cell} * patchCells;
        return u >= p.corner[0] && u < p.corner[0] + edge && v >= p.corner[1] && v < p.corner[1] + edge;
    }));
}

TEST(Mesh, CoversThePlaneExactlyOnce) {
    for (const double height : {0.001, 2.0, 300.0, 1e5}) {
        const std::vector<PlacedPatch> patches = patchesFor(allAround({3.1, -7.7}, height));
        const double reach = std::max(100e3, 4000 * height) * 0.7;
        for (double r = 0.37; r < reach; r *= 1.9)
            for (double angle = 0.1; angle < 6.2; angle += 0.61)
                EXPECT_EQ(cover(patches, r * std::cos(angle), r * std::sin(angle)), 1)
                    << "height " << height << " r " << r << " angle " << angle;
    }
}

TEST(Mesh, SaysWhichPatchesTheSeaEndsWith) {
    for (const double height : {2.0, 1e5}) {
        const std::vector<PlacedPatch> patches = patchesFor(allAround({3.1, -7.7}, height));
        const auto wider = [](const PlacedPatch& a, const PlacedPatch& b) { return a.cell < b.cell; };
        const double coarsest = std::max_element(patches.begin(), patches.end(), wider)->cell;
        for (const PlacedPatch& p : patches) EXPECT_EQ(p.range < 0, p.cell == coarsest);
    }
}

TEST(Mesh, VerticesStayWhereTheyAreWhenTheEyeMoves) {
    // Relative corners plus the eye are multiples of the patch's edge.
    const glm::dvec2 eye(1234.567, -98.76);
    for (const PlacedPatch& p : patchesFor(allAround(eye, 2))) {
        if (double{p.cell} * range > 2000) continue; // beyond, a float corner rounds to centimetres
        const double edge = double{p.cell} * patchCells;
        const double lattice = (p.corner[0] + eye.x) / edge;
        EXPECT_NEAR(lattice, std::round(lattice), 1e-3);
    }
}

double glide(const PlacedPatch& p, double distance) {
    return std::clamp((distance / std::abs(double{p.range}) - 0.7) / (0.95 - 0.7), 0.0, 1.0);
}

/// As surface.vert does it, in floats.
glm::vec2 vertexOf(const MeshLattice& lattice, const MeshPatch& patch, const glm::ivec2& grid, float glided) {
    const glm::vec2 origin(lattice.origin);
    const auto width = static_cast<float>(lattice.cell);
    const int cell = static_cast<int>(std::round(patch.cell / width));
    const glm::ivec2 at = glm::ivec2(patch.corner[0], patch.corner[1]) + grid * cell,
                     moves = (grid & 1) * cell;
    return origin + (glm::vec2(at - moves) + (1 - glided) * glm::vec2(moves)) * width;
}

/// Where a fine patch touches a coarser one its vertices must have glided fully, the coarser one's not at
/// all.
void expectNoCracks(const std::vector<PlacedPatch>& patches, double height) {
    const double end = 3000;
    int seams = 0;
    for (const PlacedPatch& fine : patches)
        for (const PlacedPatch& coarse : patches) {
            if (coarse.cell <= fine.cell || std::abs(fine.corner[0]) > end || std::abs(fine.corner[1]) > end)
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

// What is nearly the same place is not: hardware rounds it to the one side or the other of a pixel's middle.
TEST(Mesh, PatchesThatMeetShareTheirVerticesToTheLastBit) {
    const double finest = 0.3; // no float has it
    for (const double height : {0.3, 2000.0})
        for (const glm::dvec2 eye : {glm::dvec2(11.3, 4.9), glm::dvec2(-98765.4321, 1e7 / 3)}) {
            const MeshView view = withWaves(allAround(eye, height));
            std::vector<MeshPatch> patches;
            const uint32_t across = selectPatches(view, finest, range, patches) + 1;
            const MeshLattice lattice = meshLattice(view, finest, range);
            const auto isFar = [&](const MeshPatch& patch) {
                return glm::length(lattice.cornerOf(patch)) > 100 + 2 * height;
            };
            std::erase_if(patches, isFar);
            // Where they begin, and where they have glided to.
            std::map<std::pair<double, double>, glm::vec2> seen;
            size_t shared = 0;
            for (const MeshPatch& patch : patches)
                for (uint32_t n = 0; n < across * across; ++n)
                    for (const float glided : {0.0f, 1.0f}) {
                        const glm::vec2 at = vertexOf(lattice, patch, {n % across, n / across}, glided);
                        const glm::dvec2 near = glm::round(glm::dvec2(at) / (lattice.cell / 4));
                        const auto [first, isNew] = seen.try_emplace({near.x, near.y}, at);
                        shared += !isNew;
                        ASSERT_EQ(first->second, at) << "from " << height << " m";
                    }
            EXPECT_GT(shared, 1000u);
        }
}

TEST(Mesh, LevelsMeetWithoutCracks) {
    for (const double height : {0.001, 0.5, 10.0, 77.0}) {
        const MeshView view = allAround({11.3, 4.9}, height);
        expectNoCracks(patchesFor(view), height);
        for (const double rangeInCells : {128.0, 192.0})
            expectNoCracks(patchesFor(withWaves(view), rangeInCells), height);
    }
}

TEST(Mesh, OfWavesIsFinerWhereTheyTouchTheEye) {
    const auto finest = [](const std::vector<PlacedPatch>& patches) { return double{patches.front().cell}; };
    for (const double rangeInCells : {128.0, 256.0}) {
        for (const double height : {0.0, 0.3, 3.0, 15.0}) {
            const MeshView view = allAround({3.1, -7.7}, height);
            EXPECT_EQ(finest(patchesFor(view, rangeInCells)), cell) << "still water";
            const double near = finest(patchesFor(withWaves(view), rangeInCells));
            EXPECT_LE(near, std::max(height / 64, 0.01)) << "from " << height << " m";
            EXPECT_GE(near, cellNearEye(0.4, cell));
        }
        // No dearer from where all is farther away than 64 cells.
        const MeshView high = allAround({3.1, -7.7}, 64 * cell + 0.1);
        EXPECT_EQ(patchesFor(withWaves(high), rangeInCells).size(), patchesFor(high, rangeInCells).size());
    }
    EXPECT_EQ(cellNearEye(0, cell), cell);
    EXPECT_LE(cellNearEye(0.4, cell), 0.01);
    EXPECT_EQ(cellNearEye(0.4, 0.01), 0.01);
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
    const std::vector<PlacedPatch> seen = patchesFor(view);
    EXPECT_LT(seen.size(), all / 2);
    EXPECT_EQ(cover(seen, 0.1, 50), 0);
    EXPECT_EQ(cover(seen, 0.1, -50), 1);
    EXPECT_EQ(cover(seen, 0.1, -50e3), 1);
}

/// By parallel lines of sight, so many degrees down, from a place beside the origin.
tests::Camera parallelCamera(double degreesDown, double height) {
    const double down = tests::radians(degreesDown);
    tests::Camera camera;
    camera.eye = glm::dvec3(11.3, 0, 4.9) + 80.0 * glm::dvec3(std::cos(down), std::sin(down), 0);
    camera.target = {11.3, 0, 4.9};
    camera.parallelHeight = height;
    camera.far = 10e3;
    return camera;
}

/// Of flat water at y = 0, as bodies see it.
MeshView meshViewOf(const tests::Camera& camera) {
    ViewGeometry geometry;
    EXPECT_STREQ(readCamera(tests::viewDesc(camera), geometry).text(), "");
    placeEye(geometry, 0);
    MeshView view;
    view.eye = {geometry.eye.x, geometry.eye.z};
    view.eyeHeight = geometry.eye.y;
    glm::dmat4 fromFoot(1);
    fromFoot[3].y = -view.eyeHeight;
    view.frustum = frustumPlanes(geometry.clipFromRelative * fromFoot, geometry.reversedDepth);
    view.parallel = parallelLines(geometry, view.eyeHeight, 0);
    return view;
}

/// Where a place of the picture, from -1 to 1, meets the water, from the eye's foot.
glm::dvec2 metAt(const tests::Camera& camera, const MeshView& view, double x, double y) {
    const glm::dmat4 inverse = glm::inverse(tests::projectionMatrix(camera) * tests::viewMatrix(camera));
    const glm::dvec3 near(inverse * glm::dvec4(x, y, 1, 1)), far(inverse * glm::dvec4(x, y, 0, 1));
    const glm::dvec3 met = glm::mix(near, far, near.y / (near.y - far.y));
    return glm::dvec2(met.x, met.z) - view.eye;
}

TEST(ParallelMesh, CoversWhatIsSeenOnceAndLittleElse) {
    for (const double degreesDown : {90.0, 35.0, 5.0})
        for (const double height : {1.0, 30.0, 900.0}) {
            tests::Camera camera = parallelCamera(degreesDown, height);
            camera.far = 200e3;
            camera.eye += (camera.eye - camera.target) * (height / 4);
            const MeshView view = meshViewOf(camera);
            const std::vector<PlacedPatch> patches = patchesFor(view);
            for (double y = -0.99; y < 1; y += 0.11)
                for (double x = -0.99; x < 1; x += 0.11) {
                    const glm::dvec2 at = metAt(camera, view, x, y);
                    EXPECT_EQ(cover(patches, at.x, at.y), 1) << degreesDown << ' ' << height;
                }
            for (const glm::dvec2 beside : {glm::dvec2(12, 0), glm::dvec2(-12, 0), glm::dvec2(0, 12)}) {
                const glm::dvec2 at = metAt(camera, view, beside.x, beside.y);
                EXPECT_EQ(cover(patches, at.x, at.y), 0) << degreesDown << ' ' << height;
            }
            EXPECT_LT(patches.size(), 800u) << degreesDown << ' ' << height;
        }
}

TEST(ParallelMesh, IsNoneWhereNoWaterIsSeen) {
    tests::Camera camera = parallelCamera(35, 20);
    EXPECT_FALSE(patchesFor(meshViewOf(camera)).empty());
    camera.far = 50;
    EXPECT_TRUE(patchesFor(meshViewOf(camera)).empty()) << "it ends before the water";
    camera.far = 1000;
    camera.target = camera.eye + glm::dvec3(-1, 1, 0);
    EXPECT_TRUE(patchesFor(meshViewOf(camera)).empty()) << "it looks up";
}

// Sight along the plane sees it from the near plane to the far one.
TEST(ParallelMesh, IsBoundedWhereThePlaneIsSeenEdgeOn) {
    for (const double degreesDown : {0.0, 0.01, 0.5}) {
        const std::vector<PlacedPatch> patches = patchesFor(meshViewOf(parallelCamera(degreesDown, 20)));
        EXPECT_GT(patches.size(), 0u);
        EXPECT_LT(patches.size(), 3000u) << degreesDown;
    }
}

// All patches are of one level, and have glided fully onto the next one's lattice when that takes over.
TEST(ParallelMesh, ChangesNothingWhenALevelTakesOver) {
    double last = 0;
    std::set<double> levels;
    for (double height = 60; height < 600; height *= 1.001) {
        const MeshView view = meshViewOf(parallelCamera(50, height));
        const std::vector<PlacedPatch> patches = patchesFor(view);
        ASSERT_FALSE(patches.empty());
        for (const PlacedPatch& p : patches) {
            EXPECT_EQ(p.cell, patches.front().cell);
            EXPECT_GT(p.range, view.parallel->distance) << "the sea ends nowhere";
        }
        const double width =
            double{patches.front().cell} * (1 + glide(patches.front(), view.parallel->distance));
        EXPECT_NEAR(width / (last > 0 ? last : width), 1, 0.02) << height;
        last = width;
        levels.insert(patches.front().cell);
    }
    EXPECT_GE(levels.size(), 3u);
}

TEST(Mesh, IndicesUseEveryVertexAndNoOther) {
    const std::vector<uint16_t> indices = patchIndices();
    for (uint32_t cells = fewestCells; cells <= patchCells; cells *= 2) {
        ASSERT_GE(indices.size(), firstPatchIndex(2 * cells));
        const std::set<uint16_t> used(indices.begin() + firstPatchIndex(cells),
                                      indices.begin() + firstPatchIndex(2 * cells));
        EXPECT_EQ(firstPatchIndex(2 * cells) - firstPatchIndex(cells), cells * cells * 6);
        EXPECT_EQ(used.size(), (cells + 1) * (cells + 1));
        EXPECT_EQ(*used.rbegin(), cells * (patchCells + 1) + cells);
    }
    EXPECT_EQ(indices.size(), firstPatchIndex(2 * patchCells));
}

/// A sea 3 m high.
const Sea& swell() {
    static const std::unique_ptr<Sea, void (*)(Sea*)> sea(
        [] {
            SeaDesc desc;
            desc.windSpeed = 12;
            return createSea(&desc, nullptr);
        }(),
        destroySea);
    return *sea;
}

TEST(Mesh, ShowsTheWavesToAThirdOfAPixel) {
    const WaveDetail waves(swell());
    for (const double height : {2.0, 50.0, 1000.0, 30e3}) {
        MeshView view = allAround({3.1, -7.7}, height);
        view.waves = &waves;
        view.pixel = 1e-3;
        const auto [patches, cells] = select(view);
        const auto lost = [&](double asWide) {
            double most = 0; // pixels
            for (const PlacedPatch& p : patches) {
                const double edge = double{p.cell} * cells;
                const glm::dvec2 corner(p.corner[0], p.corner[1]);
                const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), corner, corner + edge);
                const double away = glm::length(glm::dvec3(nearest, height));
                most = std::max(most, waves.lostBetween(double{p.cell} * asWide) / (away * view.pixel));
            }
            return most;
        };
        EXPECT_TRUE(cells == patchCells || lost(1) <= 0.334) << "from " << height << " m";
        EXPECT_TRUE(cells == fewestCells || lost(2) > 0.333) << "from " << height << " m";
    }
}

TEST(Mesh, OfStillWaterHasTheFewestCellsOverTheSamePatches) {
    const WaveDetail still;
    MeshView view = allAround({3.1, -7.7}, 2);
    const std::vector<PlacedPatch> whole = patchesFor(view);
    view.waves = &still;
    view.pixel = 1e-3;
    const auto [patches, cells] = select(view);
    ASSERT_EQ(cells, fewestCells);
    ASSERT_EQ(patches.size(), whole.size());
    for (size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(patches[i].corner[0], whole[i].corner[0]);
        EXPECT_EQ(patches[i].range, whole[i].range);
        EXPECT_EQ(patches[i].cell * fewestCells, whole[i].cell * patchCells);
    }
}

TEST(WaveDetail, IsLostAsCellsWiden) {
    const WaveDetail waves(swell());
    const double deviation = significantWaveHeight(swell()) / 4;
    double last = 0;
    for (double width = 0.01; width < 1000; width *= 2) {
        EXPECT_GE(waves.lostBetween(width), last);
        last = waves.lostBetween(width);
    }
    EXPECT_NEAR(last, deviation, 0.01 * deviation);
    EXPECT_LT(waves.lostBetween(0.01), 0.01 * deviation);
}

TEST(Globe, FallsAwayAsABall) {
    constexpr long double radius = 6.371e6L;
    const Globe globe = Globe::of(static_cast<double>(radius));
    for (const long double away : {1.0L, 1e3L, 1e5L, 1e6L, 6e6L}) {
        const long double drop = radius - std::sqrt(radius * radius - away * away);
        const double ratio = globe.dropAt(static_cast<double>(away * away)) / static_cast<double>(drop);
        EXPECT_NEAR(ratio, 1, away < 10 ? 1e-4 : 1e-8);
    }
    EXPECT_GT(globe.dropAt(1e20), 6e6) << "beyond the ball it only goes on falling";
    EXPECT_EQ(Globe{}.dropAt(1e20), 0);
    for (const double height : {0.0, 2.0, 1e4, 1e5}) {
        const double away = globe.horizonFrom(height);
        const double dip = std::acos(static_cast<double>(radius) / (static_cast<double>(radius) + height));
        EXPECT_NEAR(height + globe.dropAt(away * away), away * std::tan(dip), 1e-6 * height);
    }
}

TEST(Mesh, OfAGlobeEndsBehindItsHorizon) {
    for (const double height : {2.0, 1e3, 1e5}) {
        MeshView view = withWaves(allAround({0, 0}, height));
        const size_t flat = patchesFor(view).size();
        view.globe = Globe::of(6.371e6);
        const std::vector<PlacedPatch> patches = patchesFor(view);
        const double away = view.globe.horizonFrom(height) + view.globe.horizonFrom(view.displacement);
        for (double turn = 0; turn < 6.28; turn += 0.1)
            EXPECT_EQ(cover(patches, away * std::cos(turn), away * std::sin(turn)), 1) << height;
        EXPECT_LT(patches.size(), flat) << height;
    }
}

TEST(Mesh, OfAGlobeShowsNoCorners) {
    const WaveDetail none;
    MeshView view = allAround({0, 0}, 1e5);
    view.waves = &none;
    view.pixel = 1e-3;
    view.globe = Globe::of(6.371e6);
    const auto [patches, cells] = select(view);
    for (const PlacedPatch& p : patches) {
        const glm::dvec2 low(p.corner[0], p.corner[1]);
        const glm::dvec2 near = glm::clamp(glm::dvec2(0), low, low + cells * double{p.cell});
        const double away = glm::length(glm::dvec3(near, view.eyeHeight));
        EXPECT_LT(view.globe.bulgeOver(double{p.cell}), 0.32 * view.pixel * away) << p.cell;
    }
}

ViewGeometry geometryOf(const tests::Camera& camera) {
    ViewGeometry geometry;
    EXPECT_STREQ(readCamera(tests::viewDesc(camera), geometry).text(), "");
    return geometry;
}

// So that what a pixel cannot show gets no cells: by parallel lines as from an eye that sees as high with 45
// degrees.
TEST(Mesh, IsToldHowManyRadiansAPixelIs) {
    tests::Camera camera;
    camera.eye.y = 3;
    const double eyes = 2 * std::tan(tests::radians(camera.fovDegrees) / 2) / camera.height;
    EXPECT_NEAR(Placing().meshView(geometryOf(camera)).pixel, eyes, 1e-6 * eyes);
    camera.parallelHeight = 20;
    camera.far = 200;
    const double parallels = 2 * std::tan(tests::radians(22.5)) / camera.height;
    EXPECT_NEAR(Placing().meshView(geometryOf(camera)).pixel, parallels, 1e-2 * parallels);
}

// Wherever the host's own is: on the middle line, over the water, as far from it as that eye would be.
TEST(ParallelEye, StandsBeforeTheWater) {
    for (const double back : {5.0, 60.0, 1e5})
        for (const double down : {10.0, 35.0, 90.0}) {
            tests::Camera camera;
            const glm::dvec3 sight(0.01, -std::sin(tests::radians(down)), -std::cos(tests::radians(down)));
            camera.target = {4, 1.5, -7};
            camera.eye = camera.target - back * glm::normalize(sight);
            camera.parallelHeight = 20;
            camera.far = 2 * back + 200;
            ViewGeometry view = geometryOf(camera);
            placeEye(view, 1.5);
            const double distance = 20 / (2 * std::tan(tests::radians(22.5)));
            const glm::dvec3 expected = camera.target - distance * glm::normalize(sight);
            EXPECT_LT(glm::distance(view.eye, expected), 0.01 * distance) << back << ' ' << down;
        }
}

} // namespace
