// The host's sky and sun stand where the reference has them, and shine as brightly.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "host/host.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 96, height = 54;

/// A turned sky, seen towards the sun.
Scene skyTowardsTheSun(double fovDeg) {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sky.rotationDeg = 70;
    scene.sun.azimuthDeg = 0;
    scene.sun.elevationDeg = 45;
    scene.sun.irradiance = {9, 8, 7};
    CameraDesc& camera = scene.cameras.emplace_back();
    camera.positionM = {0, 0, 0};
    camera.targetM = {1, 1, 0};
    camera.verticalFovDeg = fovDeg;
    return scene;
}

struct Compared {
    double brightness; ///< the host's mean over the reference's
    double apart;      ///< mean of the differences, over the reference's mean
};

Compared compared(const Scene& scene) {
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    EXPECT_TRUE(host) << error.text;
    if (!host) return {};
    const Picture drawn = tests::rendered(*host, scene, width, height);
    const Picture traced =
        tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 16}).color;
    double sum = 0, sumTraced = 0, apart = 0;
    for (size_t i = 1; i < traced.rgba.size(); i += 4) {
        sum += double{drawn.rgba[i]};
        sumTraced += double{traced.rgba[i]};
        apart += std::abs(double{drawn.rgba[i]} - double{traced.rgba[i]});
    }
    std::printf("%.4f as bright, %.4f apart\n", sum / sumTraced, apart / sumTraced);
    return {sum / sumTraced, apart / sumTraced};
}

TEST(SkyOfTheHost, IsTurnedAsTraced) {
    Scene scene = skyTowardsTheSun(40);
    scene.cameras[0].targetM = {-1, 0.5, 0.3}; // away from the sun
    const Compared found = compared(scene);
    EXPECT_NEAR(found.brightness, 1, 0.01);
    EXPECT_LT(found.apart, 0.02);
}

TEST(SkyOfTheHost, HasASunAsWideAndBrightAsTraced) {
    const Compared found = compared(skyTowardsTheSun(1));
    EXPECT_NEAR(found.brightness, 1, 0.02);
    EXPECT_LT(found.apart, 0.1);
}

TEST(SkyOfTheHost, ItsSunsLightStraysAlikeToAllSides) {
    const Scene scene = skyTowardsTheSun(10);
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host && host->load(scene, error)) << error.text;
    FrameDesc frame = {width, height, scene.cameras[0], 0, Aov::color};
    const std::optional<Picture> bare = host->render(frame, error);
    frame.bloom = true;
    const std::optional<Picture> bloomed = host->render(frame, error);
    ASSERT_TRUE(bare && bloomed) << error.text;
    double least = 1e9, most = 0;
    for (const size_t x : {width / 2 - 7, width / 2 + 6})
        for (const size_t y : {height / 2 - 7, height / 2 + 6}) {
            const size_t i = 4 * (y * width + x) + 1;
            const auto strayed = static_cast<double>(bloomed->rgba[i] - bare->rgba[i]);
            least = std::min(least, strayed);
            most = std::max(most, strayed);
        }
    std::printf("%.4g to %.4g\n", least, most);
    EXPECT_GT(least, 0);
    EXPECT_LT(most, 1.05 * least);
}

} // namespace
