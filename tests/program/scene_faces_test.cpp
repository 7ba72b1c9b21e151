// No two faces of the scenes that come with the program fight for the same pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <filesystem>
#include <map>
#include <utility>

#include "host/files/mesh_file.h"
#include "host/water/placement.h"
#include "scene/scene.h"
#include "tests/program/coplanar.h"
#include "tests/program/demo_scenes.h"

namespace {

using tests::Face;
using tests::Overlap;

constexpr double gap = 1e-4, area = 1e-4; // a tenth of a millimetre, a square centimetre

/// A file and one of its materials.
struct Source {
    std::string file;
    uint32_t material;
    auto operator<=>(const Source&) const = default;
};

/// Of a file: two materials, or twice the same, whose faces do lie in each other, by so many cm^2 at most.
struct Known {
    std::string_view file;
    uint32_t low, high;
    double most;
};

constexpr Known known[] = {
    // Boxes of one colour that run into each other at corners: frames, rails, chairs, walls, edges of slabs.
    {"bridge.glb", 0, 0, 330},
    {"bridge.glb", 2, 2, 81000},
    {"floor.glb", 3, 3, 4600},
    {"harbour.glb", 0, 0, 2450},
    {"harbour.glb", 2, 2, 50},
    {"harbour.glb", 6, 6, 8500},
    {"sailing_boat.glb", 1, 1, 80},
    {"sailing_boat_at_anchor.glb", 1, 1, 80},
    {"pool.glb", 1, 1, 2750},
    {"pool.glb", 3, 3, 930},
    {"pool.glb", 5, 5, 29000},
    {"pool.glb", 11, 11, 290},
    // Leaves that lie flat on each other: green on green.
    {"pool.glb", 12, 12, 480000},
    {"underwater.glb", 7, 7, 210},
    // Undersides of what stands on one floor, which nobody sees.
    {"floor.glb", 0, 3, 2450},
    {"harbour.glb", 0, 6, 580},
    // Window panes as thick as the bars that hold them.
    {"harbour.glb", 6, 8, 1560},
};

double allowed(const std::string& file, uint32_t low, uint32_t high) {
    for (const Known& k : known)
        if (k.file == file && k.low == low && k.high == high) return k.most;
    return 0;
}

struct Faces {
    std::vector<Face> faces;
    std::vector<Source> sources;
};

void add(const demos::MeshDesc& desc, Faces& out) {
    demos::Error error;
    const auto mesh = demos::readMesh(desc.file, error);
    glm::dmat4 worldFromMesh;
    ASSERT_TRUE(mesh && demos::placement(desc, 0, worldFromMesh, error)) << error.text;
    for (const demos::MeshPart& part : mesh->parts) {
        const auto source = static_cast<uint32_t>(out.sources.size());
        out.sources.push_back({desc.file.filename().string(), part.material});
        for (uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3) {
            Face& face = out.faces.emplace_back();
            for (uint32_t c = 0; c < 3; ++c)
                face.corners[c] =
                    worldFromMesh * glm::dvec4(mesh->vertices[mesh->indices[i + c]].position, 1);
            face.source = source;
        }
    }
}

std::map<std::pair<Source, Source>, std::vector<Overlap>> byMaterials(const std::vector<Overlap>& overlaps,
                                                                      const std::vector<Source>& sources) {
    std::map<std::pair<Source, Source>, std::vector<Overlap>> found;
    for (const Overlap& overlap : overlaps) {
        const auto [low, high] = std::minmax(sources[overlap.sources[0]], sources[overlap.sources[1]]);
        found[{low, high}].push_back(overlap);
    }
    return found;
}

TEST(SceneFaces, DoNotLieInEachOther) {
    size_t count = 0;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        demos::Error error;
        const auto scene = demos::loadScene(file, {}, error);
        ASSERT_TRUE(scene) << error.text;
        Faces faces;
        for (const demos::MeshDesc& mesh : scene->meshes) add(mesh, faces);
        const std::vector<Overlap> found = tests::coplanarOverlaps(faces.faces, gap, area);
        for (const auto& [pair, overlaps] : byMaterials(found, faces.sources)) {
            const auto& [a, b] = pair;
            double together = 0; // [cm^2]
            for (const Overlap& overlap : overlaps) together += 1e4 * overlap.area;
            if (together <= (a.file == b.file ? allowed(a.file, a.material, b.material) : 0)) continue;
            const Overlap& most = *std::ranges::max_element(overlaps, {}, &Overlap::area);
            ADD_FAILURE() << a.file << ", material " << a.material << ", and " << b.file << ", material "
                          << b.material << ", lie in each other on " << together << " cm^2, most at "
                          << most.at.x << ' ' << most.at.y << ' ' << most.at.z << ", facing " << most.facing.x
                          << ' ' << most.facing.y << ' ' << most.facing.z;
        }
        count += faces.faces.size();
    }
    EXPECT_GT(count, 100000u);
}

/// Half a square of a metre, so high over the origin and turned by `degrees` about X.
Face half(double height, double degrees = 0, glm::dvec3 moved = {}) {
    const double s = std::sin(glm::radians(degrees)), c = std::cos(glm::radians(degrees));
    Face face;
    face.corners[0] = moved + glm::dvec3(0, height, 0);
    face.corners[1] = moved + glm::dvec3(0, height - s, c);
    face.corners[2] = moved + glm::dvec3(1, height, 0);
    return face;
}

TEST(CoplanarFaces, AreFoundWhereTheyOverlapAndFaceTheSameWay) {
    const auto overlap = [](const Face& other) {
        const std::vector<Overlap> found = tests::coplanarOverlaps({half(0), other}, gap, area);
        EXPECT_LE(found.size(), 1u);
        return found.empty() ? 0 : found[0].area;
    };
    EXPECT_NEAR(overlap(half(0)), 0.5, 1e-12);
    EXPECT_NEAR(overlap(half(0.5 * gap)), 0.5, 1e-12);
    EXPECT_NEAR(overlap(half(0, 0, {0.5, 0, 0})), 0.125, 1e-12);
    EXPECT_EQ(overlap(half(2 * gap)), 0);
    EXPECT_EQ(overlap(half(0, 1)), 0) << "they part";
    EXPECT_EQ(overlap(half(0, 180)), 0) << "beside it, and facing down";
    EXPECT_EQ(overlap(half(0, 0, {1, 0, 0})), 0) << "beside it";
    Face turned = half(0);
    std::swap(turned.corners[0], turned.corners[1]);
    EXPECT_EQ(overlap(turned), 0) << "facing down";
}

TEST(CoplanarFaces, AreFoundOnceAmongMany) {
    std::vector<Face> faces;
    for (int i = 0; i < 1000; ++i)
        faces.push_back(half(0, 0, {1.5 * (i % 25), i / 500, 1.5 * (i / 25 % 20)}));
    EXPECT_EQ(tests::coplanarOverlaps(faces, gap, area).size(), 0u);
    for (int i = 0; i < 1000; i += 10) faces.push_back(faces[static_cast<size_t>(i)]);
    EXPECT_EQ(tests::coplanarOverlaps(faces, gap, area).size(), 100u);
}

// As land that goes on to the horizon, beside what grows on it.
TEST(CoplanarFaces, AreFoundAmongFacesOfAnySize) {
    std::vector<Face> faces;
    const auto add = [&](double size, glm::dvec3 moved) {
        Face face = half(0);
        for (glm::dvec3& corner : face.corners) corner = size * corner + moved;
        faces.push_back(face);
    };
    for (int i = 0; i < 20000; ++i) add(0.02, {0, 0.02 * (i / 100), 0.02 * (i % 100)});
    for (const double height : {1.0, 5.0}) add(8e4, {-2e4, height, -2e4});
    EXPECT_EQ(tests::coplanarOverlaps(faces, gap, area).size(), 100u);
}

} // namespace
