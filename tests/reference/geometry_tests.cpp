// What a ray may hit is what the host draws: back faces and cut-outs are not, but for shadows.
#include <gtest/gtest.h>

#include "reference/geometry.h"

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
        material.baseTexture = 0;
        material.alphaCutoff = 0.5f;
    }
    mesh.materials.push_back(material);
    return mesh;
}

class Square {
  public:
    Square(bool doubleSided, bool masked) : model_(square(doubleSided, masked)) {
        Error error;
        EXPECT_TRUE(geometry_.create(error)) << error.text;
        geometry_.add({&model_, glm::dmat4(1)}, {0, 0, 0});
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
