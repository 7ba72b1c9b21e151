// A scene with several waters, as they are measured against each other.
#include <gtest/gtest.h>

#include "host/host.h"
#include "scene/scene.h"

namespace {

using namespace demos;

TEST(Waters, TakeTurnsOverOneScene) {
    Error error;
    const std::optional<Scene> scene =
        loadScene(std::string(SEAGLASS_SCENES) + "/harbour.toml", {"water.waves.samples=64"}, error);
    ASSERT_TRUE(scene) << error.text;
    WaterDesc flat = *scene->water;
    flat.waves.reset();
    flat.foam.reset();
    flat.reflection->technique = "sky";
    WaterDesc planar = flat;
    planar.reflection->technique = "planar";
    const std::unique_ptr<Host> host = Host::create({{}, true}, error);
    ASSERT_TRUE(host) << error.text;
    ASSERT_TRUE(host->load(*scene, error) && host->addWater(flat, error) && host->addWater(planar, error))
        << error.text;

    FrameDesc frame{160, 90, scene->cameras.front(), scene->timeS, Aov::color, 0};
    uint32_t rounds = 0;
    const auto count = [&](uint32_t, uint32_t) { return ++rounds > 0; };
    const std::optional<ComparedTimes> times = host->measureWaters(frame, 3, count, error);
    ASSERT_TRUE(times) << error.text;
    EXPECT_EQ(rounds, 5u) << "with two to warm up";
    EXPECT_GT(times->floor.ms, 0);
    ASSERT_EQ(times->waters.size(), 3u);
    EXPECT_GT(times->waters[0].reflection.ms, 0);
    EXPECT_GT(times->waters[0].ofFloor.ms, 0);
    EXPECT_EQ(times->waters[1].reflection.ms, 0);
    const auto has = [&](size_t water, const std::string& name) {
        for (const PassTime& pass : times->waters[water].passes)
            if (pass.name == name) return true;
        return false;
    };
    for (size_t water = 0; water < 3; ++water)
        EXPECT_TRUE(has(water, "host_opaque") && has(water, "water_draw")) << water;
    EXPECT_TRUE(has(0, "waves_upload"));
    EXPECT_FALSE(has(1, "waves_upload"));
    // Only a planar reflection has the scene drawn again, and pays for it.
    EXPECT_FALSE(has(0, "host_mirrored") || has(1, "host_mirrored"));
    ASSERT_TRUE(has(2, "host_mirrored"));
    for (const PassTime& pass : times->waters[2].passes)
        if (pass.name == "host_mirrored") {
            EXPECT_GE(times->waters[2].reflection.ms, pass.ms) << "a part of it in every round";
        }
    const auto stopped = host->measureWaters(
        frame, 3, [](uint32_t, uint32_t) { return false; }, error);
    EXPECT_TRUE(stopped && stopped->waters.empty());

    // Each is drawn as if it were the scene's only one.
    frame.water = 1;
    const std::optional<Picture> second = host->render(frame, error);
    ASSERT_TRUE(second) << error.text;
    Scene alone = *scene;
    alone.water = flat;
    ASSERT_TRUE(host->load(alone, error)) << error.text;
    EXPECT_FALSE(host->render(frame, error)) << "it has one water again";
    frame.water = 0;
    const std::optional<Picture> only = host->render(frame, error);
    ASSERT_TRUE(only) << error.text;
    EXPECT_EQ(second->rgba, only->rgba);
    EXPECT_EQ(host->validationMessages(), 0u);
}

} // namespace
