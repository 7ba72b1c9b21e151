// What a ray may hit is what the host draws: back faces and cut-outs are not, but for shadows.
#include <cmath>

#include <gtest/gtest.h>

#include "reference/geometry.h"
#include "reference/shade/shade_opaque.h"

namespace {

using namespace demos;

/// A square of 2 m around the origin, facing +Z; its texture is clear on the left half and solid on the
/// right.
Mesh square(bool doubleSided, bool masked) {
    Mesh mesh;
    for (const glm::vec2& corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        MeshVertex vertex{};
        vertex.position = glm::vec3(corner, 0);
        vertex.normal = {0, 0, 1};
        vertex.uv = corner * 0.5f + 0.5f;
        for (uint16_t& channel : vertex.color) channel = 65535;
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.parts.push_back({0, 6, 0, {}, {}});
    MeshMaterial material;
    material.doubleSided = doubleSided;
    if (masked) {
        MeshTexture texture;
        texture.width = 2;
        texture.height = 1;
        texture.rgba = {255, 255, 255, 0, 255, 255, 255, 255};
        texture.wrapU = texture.wrapV = Wrap::clamp;
        mesh.textures.push_back(texture);
        material.textures[baseSlot] = 0;
        material.alphaCutoff = 0.5f;
    }
    mesh.materials.push_back(material);
    return mesh;
}

/// Of radius 1 around the origin, as round as normals make 12 by 8 patches.
Mesh ball() {
    constexpr uint32_t around = 12, down = 8;
    Mesh mesh;
    for (uint32_t j = 0; j <= down; ++j)
        for (uint32_t i = 0; i <= around; ++i) {
            const float azimuth = 6.2831853f * static_cast<float>(i) / around;
            const float polar = 3.14159265f * static_cast<float>(j) / down;
            MeshVertex vertex{};
            vertex.position = {std::sin(polar) * std::cos(azimuth), std::cos(polar),
                               -std::sin(polar) * std::sin(azimuth)};
            vertex.normal = vertex.position;
            mesh.vertices.push_back(vertex);
        }
    for (uint32_t j = 0; j < down; ++j)
        for (uint32_t i = 0; i < around; ++i) {
            const uint32_t a = j * (around + 1) + i, b = a + around + 1;
            for (const uint32_t corner : {a, b, a + 1, b, b + 1, a + 1}) mesh.indices.push_back(corner);
        }
    mesh.parts.push_back({0, static_cast<uint32_t>(mesh.indices.size()), 0, {}, {}});
    mesh.materials.emplace_back();
    return mesh;
}

class Square {
  public:
    Square(bool doubleSided, bool masked) : model_(square(doubleSided, masked)) {
        Error error;
        EXPECT_TRUE(geometry_.create(error)) << error.text;
        geometry_.add(model_, glm::dmat4(1), {0, 0, 0});
        EXPECT_TRUE(geometry_.build(error)) << error.text;
    }
    /// Along Z from 5 m before it (+1) or behind it (-1).
    bool hit(float x, float side) const {
        reference::Ray ray = along(x, side);
        reference::Hit found;
        return geometry_.trace(ray, reference::Kind::everything, found);
    }
    bool shades(float x, float side) const {
        const reference::Ray ray = along(x, side);
        reference::Hit found;
        const bool stops = geometry_.traceLight(ray, reference::Kind::everything, found);
        EXPECT_TRUE(!stops || std::abs(found.distance - 5) < 1e-4f);
        EXPECT_EQ(stops,
                  geometry_.occluded(ray.origin, ray.direction, reference::Kind::everything, ray.footprint));
        return stops;
    }

  private:
    static reference::Ray along(float x, float side) {
        reference::Ray ray;
        ray.origin = {x, 0.1f, 5 * side};
        ray.direction = {0, 0, -side};
        ray.footprint = reference::footprintAfter(ray.origin, ray.direction, 0, 1e-4f);
        return ray;
    }
    reference::Model model_;
    reference::Geometry geometry_;
};

// Facets that turn away from a light which the round thing they stand for faces lie in their own shadow.
TEST(Geometry, RoundThingsDoNotShadeThemselvesBeforeTheTerminator) {
    Error error;
    const reference::Model model(ball());
    reference::Geometry geometry;
    ASSERT_TRUE(geometry.create(error)) << error.text;
    geometry.add(model, glm::dmat4(1), glm::dvec3(0));
    ASSERT_TRUE(geometry.build(error)) << error.text;
    const glm::vec3 towardsLight = glm::normalize(glm::vec3(0.9f, 0.4f, 0.1f));
    int lit = 0, dark = 0, fromFacets = 0;
    for (int y = -19; y <= 19; ++y)
        for (int x = -19; x <= 19; ++x) {
            reference::Ray ray;
            ray.origin = {0.05f * static_cast<float>(x) + 0.01f, 0.05f * static_cast<float>(y) + 0.02f, 3};
            ray.footprint = reference::footprintAfter(ray.origin, ray.direction, 0, 1e-4f);
            reference::Hit hit;
            if (!geometry.trace(ray, reference::Kind::opaque, hit)) continue;
            if (glm::dot(reference::normalAt(hit), towardsLight) < 0.01f) continue;
            const auto shaded = [&](const glm::vec3& from) {
                return geometry.occluded(from, towardsLight, reference::Kind::opaque, ray.footprint) ? 1 : 0;
            };
            ++lit;
            dark += shaded(reference::lightLeavesFrom(hit));
            fromFacets += shaded(hit.position + hit.facing() * reference::clearanceAt(hit.position));
        }
    std::printf("%d of %d lit places are dark, %d as facets\n", dark, lit, fromFacets);
    EXPECT_GT(lit, 100);
    EXPECT_GT(fromFacets, 5);
    EXPECT_EQ(dark, 0);
}

TEST(Geometry, BackFacesAreCulledButCastShadows) {
    const Square single(false, false), both(true, false);
    EXPECT_TRUE(single.hit(0.5f, 1));
    EXPECT_FALSE(single.hit(0.5f, -1));
    EXPECT_TRUE(single.shades(0.5f, -1));
    EXPECT_TRUE(both.hit(0.5f, 1));
    EXPECT_TRUE(both.hit(0.5f, -1));
    EXPECT_FALSE(both.hit(1.5f, 1));
}

TEST(Geometry, CutOutsLetRaysAndLightThrough) {
    const Square leaf(true, true);
    for (const float side : {1.0f, -1.0f}) {
        EXPECT_TRUE(leaf.hit(0.6f, side));
        EXPECT_FALSE(leaf.hit(-0.6f, side));
        EXPECT_TRUE(leaf.shades(0.6f, side));
        EXPECT_FALSE(leaf.shades(-0.6f, side));
    }
}

} // namespace
