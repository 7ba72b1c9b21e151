// The scenes that come with the program ask for seas that their cascades can hold.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "host/water/waves.h"
#include "program/sea/lost_waves.h"
#include "scene/scene.h"
#include "tests/program/demo_scenes.h"

namespace {

TEST(DemoScenes, HoldTheWavesThatTheyAskFor) {
    size_t count = 0;
    for (const std::filesystem::path& file : tests::demoScenes()) {
        demos::Error error;
        const auto scene = demos::loadScene(file, {}, error);
        ASSERT_TRUE(scene) << error.text;
        if (!scene->water || !scene->water->waves) continue;
        demos::SceneSea asked;
        ASSERT_TRUE(demos::seaOf(*scene->water->waves, asked, error)) << error.text;
        seaglass::SeaError problem;
        const std::unique_ptr<seaglass::Sea, void (*)(seaglass::Sea*)> sea(
            seaglass::createSea(&asked.desc, &problem), seaglass::destroySea);
        ASSERT_TRUE(sea) << problem.text;
        const double share = seaglass::resolvedShare(*sea);
        std::printf("%s: %.2f\n", file.filename().c_str(), share);
        EXPECT_GE(share, demos::leastResolvedInPictures) << file;
        ++count;
    }
    EXPECT_GE(count, 5u);
}

// Without that, a wave that covers the eye is drawn as a sea that one looks through from above.
TEST(DemoScenes, EyesThatWavesGoOverAreInTheWater) {
    for (const std::filesystem::path& file : tests::demoScenes()) {
        demos::Error error;
        auto scene = demos::loadScene(file, {}, error);
        ASSERT_TRUE(scene) << error.text;
        if (!scene->water || !scene->water->waves) continue;
        demos::WavesDesc& waves = *scene->water->waves;
        waves.beaufort = demos::WavesDesc::noForce;
        waves.windMps = 25;
        demos::SceneSea asked;
        ASSERT_TRUE(demos::seaOf(waves, asked, error)) << error.text;
        const std::unique_ptr<seaglass::Sea, void (*)(seaglass::Sea*)> sea(
            seaglass::createSea(&asked.desc, nullptr), seaglass::destroySea);
        ASSERT_TRUE(sea) << file;
        const double crests = seaglass::significantWaveHeight(*sea) * 0.93; // the highest of a thousand waves
        bool covered = false;
        for (const demos::CameraDesc& camera : scene->cameras)
            covered = covered || camera.positionM[1] - scene->water->levelM < crests;
        std::printf("%s: crests of %.2f m\n", file.filename().c_str(), crests);
        EXPECT_TRUE(!covered || scene->water->underwater) << file;
    }
}

TEST(DemoScenes, WaterIsOfItsTint) {
    demos::RefractionDesc refraction;
    refraction.tint = {0.01, 0.2, 0.15};
    refraction.visibilityM = 6;
    const float tint[3] = {0.01f, 0.2f, 0.15f};
    seaglass::WaterCoefficients asked{};
    ASSERT_TRUE(seaglass::tintedWater(tint, 6, &asked, nullptr));
    const seaglass::WaterCoefficients told = demos::coefficientsOf(refraction);
    for (int band = 0; band < 3; ++band) {
        EXPECT_EQ(told.absorption[band], asked.absorption[band]);
        EXPECT_EQ(told.backscatter[band], asked.backscatter[band]);
    }
    refraction.tint[0] = 1e-60; // 0 as a float
    EXPECT_EQ(demos::coefficientsOf(refraction).backscatter[1], asked.backscatter[1]);
    const seaglass::WaterCoefficients plain = demos::coefficientsOf(demos::RefractionDesc{});
    EXPECT_EQ(plain.absorption[0], 0.345f);
}

} // namespace
