// Things that move are, at each moment, where they would stand still: drawn and traced.
#include <gtest/gtest.h>

#include "scene/motion/motion.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"
#include "tests/reference/box_file.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 64, height = 48;
constexpr double momentS = 3;

/// A box over calm water, before a camera; both move.
Scene moving() {
    Scene scene;
    scene.sky.file = testing::TempDir() + "moving_sky.hdr";
    tests::writeAll(scene.sky.file, tests::sampleSky());
    scene.sun.azimuthDeg = 60;
    MeshDesc& box = scene.meshes.emplace_back();
    box.file = tests::writeBoxes("box", {{{-1.5, -1, -0.6}, {1.5, 1.2, 0.6}}}, 0.7);
    box.positionM = {-4, 0, 0};
    box.keyframes = {{2, {0, 0, -1}, 40}, {5, {4, 0, 2}, 80}};
    box.exclusionVolumes.emplace_back().pointsM = {{-1, -0.3}, {1, -0.3}, {1, 0.3}, {-1, 0.3}};
    scene.water.emplace().reflection.emplace();
    CameraDesc& camera = scene.cameras.emplace_back();
    camera.positionM = {0, 4, 10};
    camera.targetM = {0, 0, 0};
    camera.keyframes = {{6, {3, 3, 9}, {1, 0, 0}, 10}};
    scene.timeS = momentS;
    return scene;
}

Scene still(Scene scene) {
    scene.meshes[0] = meshAt(scene.meshes[0], momentS);
    scene.cameras[0] = cameraAt(scene.cameras[0], momentS);
    return scene;
}

Picture drawn(Host& host, const Scene& scene) {
    Error error;
    EXPECT_TRUE(host.load(scene, error)) << error.text;
    std::optional<Picture> picture;
    // Nothing stays where it was.
    for (const double timeS : {-4.0, 40.0, scene.timeS}) {
        picture = host.render({width, height, scene.cameras[0], timeS, Aov::color}, error);
        EXPECT_TRUE(picture) << error.text;
    }
    return *picture;
}

TEST(Moving, IsWhereItWouldStandStill) {
    HostDesc desc;
    desc.validation = true;
    Error error;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Scene scene = moving();
    Scene before = still(scene);
    before.meshes[0].positionM = scene.meshes[0].positionM;
    const std::vector<float> now = drawn(*host, scene).rgba;
    EXPECT_EQ(now, drawn(*host, still(scene)).rgba);
    EXPECT_NE(now, drawn(*host, before).rgba) << "the box is seen";
    const auto trace = [&](const Scene& of) {
        return tests::traced(of, {width, height, of.cameras[0], momentS, 1}).color.rgba;
    };
    EXPECT_EQ(trace(scene), trace(still(scene)));
    EXPECT_NE(trace(scene), trace(before));
    EXPECT_EQ(host->validationMessages(), 0u);
}

/// The highest row in which the box, which alone is red, is seen; its mirror image is lower.
double topOf(const Picture& picture) {
    for (size_t i = 0; i < picture.rgba.size(); i += 4)
        if (picture.rgba[i] > 2 * picture.rgba[i + 2]) return static_cast<double>(i / 4 / picture.width);
    return -1;
}

TEST(Moving, FloatsAsTracedOnTheSameSea) {
    Scene scene = still(moving());
    scene.sky.intensity = 0.05;
    scene.sun.irradiance = {9, 0, 0};
    scene.water->waves.emplace().windMps = 12;
    scene.water->waves->samples = 64;
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const double calm = topOf(drawn(*host, scene));
    scene.meshes[0].floats = true;
    double moved = 0;
    for (const double timeS : {0.0, 1.5}) {
        scene.timeS = timeS;
        const double seen = topOf(drawn(*host, scene)),
                     traced = topOf(tests::traced(scene, {width, height, scene.cameras[0], timeS, 1}).color);
        std::printf("at %.1f s its top is at row %.2f drawn and %.2f traced, in calm water at %.2f\n", timeS,
                    seen, traced, calm);
        EXPECT_NEAR(seen, traced, 1);
        moved = std::max(moved, std::abs(seen - calm));
    }
    EXPECT_GE(moved, 3);
}

} // namespace
