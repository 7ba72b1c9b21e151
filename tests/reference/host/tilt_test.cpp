// Tilted water: the reference traces in the plane's own axes what the host draws in the world's.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/program/demo_scenes.h"
#include "tests/reference/box_world.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 90;

/// Water that falls towards the eye and to its left, between the harbour's quays.
Scene slope(double tiltDeg) {
    Error error;
    auto scene = loadScene(tests::demoScene("harbour"), {}, error);
    EXPECT_TRUE(scene) << error.text;
    scene->water->tiltDeg = tiltDeg;
    scene->water->tiltTowardsDeg = 110;
    return *scene;
}

struct Shades {
    double mean = 0;  ///< of the drawn picture
    double apart = 0; ///< mean difference of the traced one, a share of that
    double bias = 0;  ///< likewise, with its sign
};

Shades compare(Host& host, const Scene& scene) {
    const Picture drawn = tests::rendered(host, scene, width, height);
    const Picture traced =
        tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 16}).color;
    Shades shades;
    for (size_t i = 0; i < drawn.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const double a = std::min(1.0, static_cast<double>(drawn.rgba[i])),
                     b = std::min(1.0, static_cast<double>(traced.rgba[i]));
        shades.mean += a;
        shades.apart += std::abs(a - b);
        shades.bias += a - b;
    }
    shades.apart /= shades.mean;
    shades.bias /= shades.mean;
    return shades;
}

TEST(TiltedWater, IsDrawnAsNearToTheTracedAsLevelWater) {
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const Shades level = compare(*host, slope(0)), tilted = compare(*host, slope(12));
    std::printf("apart by %.4f level, %.4f tilted; bias %.4f and %.4f\n", level.apart, tilted.apart,
                level.bias, tilted.bias);
    EXPECT_LT(tilted.apart, 1.3 * level.apart);
    EXPECT_LT(std::abs(tilted.bias), 0.03);
}

/// Water that nobody sees lends the picture its axes, and no more.
TEST(TiltedWater, LeavesAllElseAsItIs) {
    std::vector<Picture> pictures;
    for (const double tiltDeg : {0.0, 50.0}) {
        Scene scene = slope(tiltDeg);
        scene.water->levelM = -500;
        scene.water->extent.emplace().sizeM = {1, 1};
        scene.water->underwater.reset();
        for (MeshDesc& mesh : scene.meshes) mesh.floats = false; // there is no water below them
        pictures.push_back(tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS}).color);
    }
    size_t differ = 0;
    double mean = 0;
    for (size_t i = 0; i < pictures[0].rgba.size(); ++i) {
        const double a = static_cast<double>(pictures[0].rgba[i]),
                     b = static_cast<double>(pictures[1].rgba[i]);
        mean += a - b;
        differ += std::abs(a - b) > 0.003 * a + 1e-4;
    }
    std::printf("%zu of %zu values differ, by %.6f in the mean\n", differ, pictures[0].rgba.size(),
                mean / static_cast<double>(pictures[0].rgba.size()));
    EXPECT_LT(differ, pictures[0].rgba.size() / 100); // edges
}

TEST(TiltedWater, HasItsExclusionVolumesWhereTheyAreInTheWorld) {
    Scene scene = slope(40);
    ExclusionVolumeDesc& volume = scene.water->exclusionVolumes.emplace_back();
    volume.positionM = {30, 4, -20};
    volume.pointsM = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    reference::World world;
    Error error;
    ASSERT_TRUE(reference::loadWorld(scene, world, error)) << error.text;
    const auto dry = [&](const glm::dvec3& at) {
        return demos::reference::isExcluded(world.excludedVolumes, world.frame.fromWorld(at));
    };
    EXPECT_TRUE(dry({30.8, 3.2, -19.2}));
    EXPECT_FALSE(dry({31.2, 3.2, -19.2}));
    EXPECT_FALSE(dry({30.8, 2.8, -19.2}));
}

} // namespace
