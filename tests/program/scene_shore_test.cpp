// The bed of a scene's shore, measured over its water's plane; and that the demo's is whole and ends out of
// sight.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "host/files/mesh_file.h"
#include "host/water/shore.h"
#include "seaglass/water_type.h"
#include "tests/program/sample.h"

namespace {

/// Samples of a bed, back in the world, lie on the mesh that they were taken of: a tetrahedron.
TEST(SceneShore, IsMeasuredFromTiltedPlanes) {
    const tests::TemporaryFolder folder;
    tests::writeSample(folder.path());
    const demos::ShoreDesc shore = {folder.path() / "tetra.gltf", {30, 2, -50}, 0.1, "here"};
    demos::WaterDesc water;
    water.levelM = 1.5;
    water.tiltDeg = 20;
    water.tiltTowardsDeg = 40;
    const demos::Plane plane = demos::waterPlane(water);
    demos::SceneShore bed;
    demos::Error error;
    ASSERT_TRUE(demos::shoreOf(shore, plane, bed, error)) << error.text;
    const glm::dvec3 n(plane[0], plane[1], plane[2]);
    const double share = 1 / (1 + n.y);
    const glm::dvec3 uAxis(1 - n.x * n.x * share, -n.x, -n.x * n.z * share),
        vAxis(-n.x * n.z * share, -n.z, 1 - n.z * n.z * share);
    const glm::dvec3 corners[] = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 2, 0}};
    constexpr size_t faces[][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    const float lowest = *std::ranges::min_element(bed.bed);
    size_t onMesh = 0;
    for (uint32_t j = 0; j < bed.desc.samples[1]; ++j)
        for (uint32_t i = 0; i < bed.desc.samples[0]; ++i) {
            const float height = bed.bed[size_t{j} * bed.desc.samples[0] + i];
            if (height <= lowest) continue;
            const glm::dvec3 world = uAxis * (bed.desc.origin[0] + i * double{bed.desc.spacing}) +
                                     vAxis * (bed.desc.origin[1] + j * double{bed.desc.spacing}) +
                                     n * (double{height} - plane[3]);
            const glm::dvec3 local = world - glm::dvec3(30, 2, -50);
            double off = 1e9;
            for (const auto& [a, b, c] : faces) {
                const glm::dvec3 from = corners[a];
                const glm::dvec3 normal = glm::cross(corners[b] - from, corners[c] - from);
                off = std::min(off, std::abs(glm::dot(glm::normalize(normal), local - from)));
            }
            EXPECT_LT(off, 1e-4) << i << ' ' << j;
            EXPECT_LT(glm::length(local - glm::dvec3(0, 0.5, 0)), 1.6);
            ++onMesh;
        }
    EXPECT_GT(onMesh, 100u);
}

using Place = std::tuple<long, long, long>;           ///< [cm]
using Edges = std::map<std::pair<Place, Place>, int>; ///< and how many triangles have each

Place placeOf(const glm::vec3& p) {
    return {std::lround(100 * p.x), std::lround(100 * p.y), std::lround(100 * p.z)};
}

/// Of a file's ground: of all that is made as its widest part.
void addGround(const char* file, Edges& edges) {
    demos::Error error;
    const std::optional<demos::Mesh> mesh =
        demos::readMesh(std::filesystem::path(SEAGLASS_SCENES) / file, error);
    ASSERT_TRUE(mesh) << error.text;
    const auto width = [](const demos::MeshPart& part) { return part.high.x - part.low.x; };
    const uint32_t ground = std::ranges::max_element(mesh->parts, {}, width)->material;
    for (const demos::MeshPart& part : mesh->parts) {
        if (part.material != ground) continue;
        for (uint32_t i = 0; i < part.indexCount; i += 3)
            for (uint32_t k = 0; k < 3; ++k) {
                const auto corner = [&](uint32_t which) {
                    const uint32_t index = mesh->indices[part.firstIndex + i + which % 3];
                    return placeOf(mesh->vertices[index].position);
                };
                const Place a = corner(k), b = corner(k + 1);
                ++edges[{std::min(a, b), std::max(a, b)}];
            }
    }
}

/// Of one triangle alone, within the ground's border [m]: what lies beyond shows through, or casts a shadow.
size_t cracks(const Edges& edges, const glm::vec2& low, const glm::vec2& high) {
    size_t count = 0;
    const auto within = [&](const Place& place) {
        const double x = double(std::get<0>(place)) / 100, z = double(std::get<2>(place)) / 100;
        return x > double{low.x} && x < double{high.x} && z > double{low.y} && z < double{high.y};
    };
    for (const auto& [edge, triangles] : edges)
        count += triangles == 1 && (within(edge.first) || within(edge.second)) ? 1 : 0;
    return count;
}

TEST(SceneGround, TheIslandHasNoGaps) {
    Edges edges;
    addGround("shore_bed.glb", edges);
    EXPECT_GT(edges.size(), 40000u);
    EXPECT_EQ(cracks(edges, {-309, -229}, {309, 269}), 0u);
}

// Swash leaves sand smooth. Where it stops on hummocks the border of the wet sand is jagged, and a hollow of
// the dunes gets wet.
TEST(SceneGround, SwashLiesOnSmoothSand) {
    demos::Error error;
    const std::optional<demos::Mesh> mesh =
        demos::readMesh(std::filesystem::path(SEAGLASS_SCENES) / "shore_bed.glb", error);
    ASSERT_TRUE(mesh) << error.text;
    std::map<float, std::map<float, float>> rows; // heights by z and x
    for (const auto& vertex : mesh->vertices)
        if (vertex.position.z > 0 && std::abs(vertex.position.x) < 60)
            rows[vertex.position.z][vertex.position.x] = vertex.position.y;
    double roughest = 0, lowest = 1e9;
    for (const auto& [z, row] : rows)
        for (auto here = std::next(row.begin()); std::next(here) != row.end(); ++here) {
            const double y{here->second};
            const double bend = double{std::prev(here)->second} + double{std::next(here)->second} - 2 * y;
            if (y > 0.2 && y < 0.5) roughest = std::max(roughest, std::abs(bend));
            if (std::hypot(double{here->first}, double{z} - 20) < 5) lowest = std::min(lowest, y);
        }
    std::printf("bends by %.4f m from sample to sample; the middle is %.2f m high\n", roughest, lowest);
    EXPECT_LT(roughest, 0.03); // 0.138 with hummocks and a hollow
    EXPECT_GT(lowest, 0.4);
}

/// Light that comes back from a bed of albedo 0.45 under so much water, in what endless water sends back
/// (Morel and Prieur 1977).
double bedsShare(double depth, size_t channel) {
    const auto [absorption, backscatter] = seaglass::waterCoefficients(seaglass::WaterType::clearOcean);
    const double scattered = double{backscatter[channel]}, lost = double{absorption[channel]} + scattered;
    return 0.45 * std::exp(-2 * lost * depth) / (0.33 * scattered / lost);
}

// From the air a bed that ends in sight is a straight edge, and land that ends there a hole: no photograph
// has either.
TEST(SceneGround, TheIslandEndsWhereNothingOfItIsSeen) {
    Edges edges;
    addGround("shore_bed.glb", edges);
    double highest = -1e9, seen = 0;
    size_t border = 0;
    for (const auto& [edge, triangles] : edges) {
        if (triangles != 1) continue;
        ++border;
        for (const Place& place : {edge.first, edge.second})
            highest = std::max(highest, double(std::get<1>(place)) / 100);
    }
    for (size_t channel = 0; channel < 3; ++channel) seen = std::max(seen, bedsShare(-highest, channel));
    std::printf("ends %.0f m deep or deeper; %.3f of deep water's light are the bed's\n", -highest, seen);
    EXPECT_GT(border, 100u);
    EXPECT_LT(seen, 0.1); // at 41 m: 1.3 in blue
}

/// Where a file's ground ends high over the water, far from the origin: edges of one triangle alone.
size_t cutOff(const char* file, double farther, double higher) {
    demos::Error error;
    const std::optional<demos::Mesh> mesh =
        demos::readMesh(std::filesystem::path(SEAGLASS_SCENES) / file, error);
    if (!mesh) return 1;
    Edges edges;
    for (size_t i = 0; i + 2 < mesh->indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) {
            const glm::vec3 a = mesh->vertices[mesh->indices[i + k]].position,
                            b = mesh->vertices[mesh->indices[i + (k + 1) % 3]].position;
            const bool counts =
                std::hypot(double{a.x}, double{a.z}) > farther && double{std::max(a.y, b.y)} > higher;
            if (counts) ++edges[std::minmax({placeOf(a), placeOf(b)})];
        }
    EXPECT_GT(edges.size(), 500u);
    return static_cast<size_t>(
        std::ranges::count_if(edges, [](const auto& edge) { return edge.second == 1; }));
}

// Air has a visual range of 33 km: clearAir() of the demos. Land that ends nearer hovers in a void.
TEST(SceneGround, ReachesAsFarAsOneSees) {
    for (const char* file : {"pool.glb", "lake.glb"}) {
        demos::Error error;
        const std::optional<demos::Mesh> mesh =
            demos::readMesh(std::filesystem::path(SEAGLASS_SCENES) / file, error);
        ASSERT_TRUE(mesh) << error.text;
        double reach[4] = {0, 0, 0, 0};
        for (const demos::MeshPart& part : mesh->parts) {
            const double here[4] = {-double{part.low.x}, double{part.high.x}, -double{part.low.z},
                                    double{part.high.z}};
            for (size_t i = 0; i < 4; ++i) reach[i] = std::max(reach[i], here[i]);
        }
        EXPECT_GT(*std::ranges::min_element(reach), 33e3) << file; // were 300 m and 4.5 km
    }
}

// From the air hills without backs are ribbons.
TEST(SceneGround, TheHarboursFarHillsHaveBacks) {
    EXPECT_EQ(cutOff("harbour.glb", 550, 1), 0u);
}

TEST(SceneGround, TheSandUnderWaterHasNoCracks) {
    Edges edges;
    addGround("underwater.glb", edges);
    EXPECT_GT(edges.size(), 10000u);
    EXPECT_EQ(cracks(edges, {-69, -119}, {69, 29}), 0u);
}

} // namespace
