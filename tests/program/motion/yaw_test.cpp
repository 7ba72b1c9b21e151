// That all that a scene turns by the same yaw turns the same way: meshes, what they keep dry, hollows of the
// water and where it ends.
#include <cmath>
#include <filesystem>
#include <iterator>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/water/exclusion_volumes.h"
#include "host/water/extent.h"
#include "host/water/placement.h"

namespace {

using demos::Vec2;

constexpr double yawDeg = 25;

glm::dmat4 worldFromMesh() {
    demos::MeshDesc mesh;
    mesh.yawDeg = yawDeg;
    glm::dmat4 out(1);
    demos::Error error;
    EXPECT_TRUE(demos::placement(mesh, 0, out, error)) << error.text;
    return out;
}

glm::dvec4 planeOf(const double (&plane)[4]) {
    return {plane[0], plane[1], plane[2], plane[3]};
}

TEST(Yaw, TurnsMeshesFromXTowardsMinusZ) {
    const glm::dvec3 ahead(worldFromMesh()[0]);
    const double turned = yawDeg * std::acos(-1.0) / 180;
    EXPECT_LT(glm::distance(ahead, glm::dvec3(std::cos(turned), 0, -std::sin(turned))), 1e-12);
}

TEST(Yaw, TurnsHollowsAsMeshesThatCarryThem) {
    demos::ExclusionVolumeDesc hollow;
    hollow.pointsM = {{-2, -0.4}, {1.5, -0.3}, {2, 0.7}, {-1, 0.5}};
    demos::MeshDesc boat;
    boat.exclusionVolumes = {hollow};
    std::vector<seaglass::ExclusionVolume> carried, alone;
    demos::addCarried(boat, worldFromMesh(), carried);
    hollow.yawDeg = yawDeg;
    demos::Error error;
    ASSERT_TRUE(demos::exclusionVolumesOf({hollow}, "here", alone, error)) << error.text;
    ASSERT_EQ(carried.size(), 1u);
    ASSERT_EQ(alone.size(), 1u);
    for (size_t i = 0; i < std::size(carried[0].planes); ++i)
        EXPECT_LT(glm::distance(planeOf(carried[0].planes[i]), planeOf(alone[0].planes[i])), 1e-12) << i;
}

TEST(Yaw, TurnsTheWatersEndAsMeshes) {
    demos::ExtentDesc extent;
    extent.shape = "polygon";
    extent.pointsM = {{-2, -0.4}, {1.5, -0.3}, {2, 0.7}};
    extent.yawDeg = yawDeg;
    demos::SceneExtent water;
    demos::Error error;
    ASSERT_TRUE(demos::extentOf(extent, water, error)) << error.text;
    for (size_t i = 0; i < extent.pointsM.size(); ++i) {
        const auto& [x, z] = extent.pointsM[i];
        const glm::dvec4 corner = worldFromMesh() * glm::dvec4(x, 0, z, 1);
        EXPECT_NEAR(water.points[2 * i], corner.x, 1e-12);
        EXPECT_NEAR(water.points[2 * i + 1], corner.z, 1e-12);
    }
}

} // namespace
