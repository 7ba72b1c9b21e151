// Water that ends: the host draws it where the reference has it.
#include <gtest/gtest.h>

#include "reference/reference.h"
#include "tests/program/demo_scenes.h"

namespace {

using namespace demos;

Scene poolOver(const ExtentDesc& extent) {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sun.elevationDeg = 40;
    scene.water.emplace();
    scene.water->levelM = -1;
    scene.water->extent = extent;
    WavesDesc waves;
    waves.windMps = 4;
    waves.fetchM = 500;
    scene.water->waves = waves;
    scene.cameras.emplace_back();
    scene.cameras[0].positionM = {1, 2, 9};
    scene.cameras[0].targetM = {0, -1, 0};
    return scene;
}

TEST(Extents, AreWhereTheReferenceHasThem) {
    ExtentDesc pool, lake;
    pool.sizeM = {8, 5};
    pool.yawDeg = 25;
    lake.shape = "polygon";
    lake.yawDeg = -15;
    lake.pointsM = {{-5, 2}, {4, 3}, {5, -6}, {1, -1}, {-4, -5}};
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    for (const ExtentDesc& extent : {pool, lake}) {
        const Scene scene = poolOver(extent);
        constexpr uint32_t width = 240, height = 135;
        ASSERT_TRUE(host->load(scene, error)) << error.text;
        const std::optional<Picture> rendered =
            host->render({width, height, scene.cameras[0], 2, Aov::normal}, error);
        ASSERT_TRUE(rendered) << error.text;
        reference::World world;
        reference::Frame frame;
        reference::FrameDesc desc;
        desc.width = width;
        desc.height = height;
        desc.camera = scene.cameras[0];
        desc.timeS = 2;
        ASSERT_TRUE(reference::loadWorld(scene, world, error)) << error.text;
        ASSERT_TRUE(reference::prepareFrame(world, desc, frame, error)) << error.text;
        size_t differ = 0, water = 0;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const bool drawn = rendered->rgba[(size_t{y} * width + x) * 4 + 1] > 0;
                reference::Hit hit;
                const bool traced = frame.geometry.trace(
                    frame.rayThrough({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}),
                    reference::Kind::everything, hit);
                differ += drawn != traced;
                water += traced;
            }
        EXPECT_GT(water, 2000u) << extent.shape;
        EXPECT_LE(differ, water / 60) << extent.shape; // pixels on its edge
    }
}

} // namespace
