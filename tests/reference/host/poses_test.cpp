// Every camera of the harbour gives a picture: finite, valid, and with water in it.
#include <cmath>

#include <gtest/gtest.h>

#include "host/host.h"
#include "scene/offset.h"
#include "scene/without.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/camera_of.h"

namespace {

using namespace demos;

constexpr uint32_t width = 256, height = 144;

size_t countNotFinite(const Picture& picture) {
    size_t count = 0;
    for (const float value : picture.rgba) count += std::isfinite(value) ? 0 : 1;
    return count;
}

/// By the normals, which are zero elsewhere.
double shareOfWater(const Picture& normals) {
    size_t count = 0;
    for (size_t i = 0; i < normals.rgba.size(); i += 4) count += normals.rgba[i + 1] != 0 ? 1 : 0;
    return static_cast<double>(count) / (width * height);
}

TEST(HarbourPoses, AreFiniteValidAndShowWater) {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene("harbour"), {}, error);
    ASSERT_TRUE(scene) << error.text;
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    std::optional<Vec3> loaded;
    for (CameraDesc camera : scene->cameras) {
        SCOPED_TRACE(camera.name);
        if (loaded != camera.offsetM) {
            loaded = camera.offsetM;
            Scene moved = *scene;
            CameraDesc moving = camera;
            applyOffset(moved, moving);
            ASSERT_TRUE(host->load(moved, error)) << error.text;
        }
        Scene empty;
        applyOffset(empty, camera);
        const std::optional<Picture> color =
            host->render({width, height, camera, scene->timeS, Aov::color}, error);
        const std::optional<Picture> normals =
            host->render({width, height, camera, scene->timeS, Aov::normal}, error);
        ASSERT_TRUE(color && normals) << error.text;
        EXPECT_EQ(countNotFinite(*color), 0u);
        if (camera.name != "straddle") { // which sees it edge on
            EXPECT_GT(shareOfWater(*normals), 0.2);
            EXPECT_LT(shareOfWater(*normals), 0.75);
        }
    }
    EXPECT_EQ(host->validationMessages(), 0u);
}

/// One pixel of this very picture was once NaN: a triangle without area had drawn it.
TEST(HarbourPoses, NoPixelOfTwoMillionIsNan) {
    Error error;
    std::optional<Scene> scene = loadScene(tests::demoScene("harbour"), {}, error);
    ASSERT_TRUE(scene) << error.text;
    takeWaves(*scene->water);
    const CameraDesc roll35 = tests::cameraOf(*scene, "roll35");
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host && host->load(*scene, error)) << error.text;
    const std::optional<Picture> color = host->render({1920, 1080, roll35, scene->timeS, Aov::color}, error);
    ASSERT_TRUE(color) << error.text;
    EXPECT_EQ(countNotFinite(*color), 0u);
}

} // namespace
