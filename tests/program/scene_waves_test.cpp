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
