// A scene with several surfaces, as they are measured against each other.
#include <gtest/gtest.h>

#include "host/host.h"
#include "scene/scene.h"
#include "scene/without.h"
#include "tests/program/demo_scenes.h"

namespace {

using namespace demos;

/// Milliseconds of a pass; none where it did not run.
std::optional<double> passOf(const SurfaceTimes& times, const std::string& name) {
    for (const PassTime& pass : times.passes)
        if (pass.name == name) return pass.ms;
    return std::nullopt;
}

/// By either clock, whatever the device is.
class Surfaces : public testing::TestWithParam<PassClock> {
  protected:
    static std::unique_ptr<Host> host(Error& error) {
        HostDesc desc;
        desc.validation = true;
        desc.clock = GetParam();
        return Host::create(desc, error);
    }
};

TEST_P(Surfaces, WatersTakeTurnsOverOneScene) {
    Error error;
    const std::optional<Scene> scene =
        loadScene(tests::demoScene("harbour"), {"water.waves.samples=64"}, error);
    ASSERT_TRUE(scene) << error.text;
    WaterDesc flat = *scene->water;
    takeWaves(flat);
    flat.reflection->technique = seaglass::ReflectionTechnique::sky;
    WaterDesc planar = flat;
    planar.reflection->technique = seaglass::ReflectionTechnique::planar;
    const std::unique_ptr<Host> host = Surfaces::host(error);
    ASSERT_TRUE(host) << error.text;
    ASSERT_TRUE(host->load(*scene, error) && host->addSurface(flat, error) && host->addSurface(planar, error))
        << error.text;

    FrameDesc frame{160, 90, scene->cameras.front(), scene->timeS, Aov::color, 0};
    uint32_t rounds = 0;
    const auto count = [&](uint32_t, uint32_t) { return ++rounds > 0; };
    const std::optional<ComparedTimes> times = host->measureSurfaces(frame, 3, count, error);
    ASSERT_TRUE(times) << error.text;
    EXPECT_EQ(rounds, 5u) << "with two to warm up";
    EXPECT_GT(times->yardsticks.floor.ms, 0);
    EXPECT_GT(times->yardsticks.fullScreen.ms, 0);
    ASSERT_EQ(times->surfaces.size(), 3u);
    EXPECT_GT(times->surfaces[0].reflection.ms, 0);
    EXPECT_GT(times->surfaces[0].ofFloor.ms, 0);
    EXPECT_EQ(times->surfaces[1].reflection.ms, 0);
    const auto has = [&](size_t water, const char* name) {
        return passOf(times->surfaces[water], name).has_value();
    };
    for (size_t water = 0; water < 3; ++water) {
        EXPECT_TRUE(has(water, "host_opaque") && has(water, "host_copy") && has(water, "water_draw"))
            << water;
        EXPECT_GE(times->surfaces[water].hostBytes, 160u * 90 * (8 + 4)) << "refraction reads the scene";
    }
    EXPECT_TRUE(has(0, "waves_upload"));
    EXPECT_FALSE(has(1, "waves_upload"));
    // Only a planar reflection has the scene drawn again, and pays for it.
    EXPECT_FALSE(has(0, "host_mirrored") || has(1, "host_mirrored"));
    ASSERT_TRUE(has(2, "host_mirrored"));
    EXPECT_GE(times->surfaces[2].reflection.ms, *passOf(times->surfaces[2], "host_mirrored"))
        << "a part of it in every round";
    const auto stopped = host->measureSurfaces(
        frame, 3, [](uint32_t, uint32_t) { return false; }, error);
    EXPECT_TRUE(stopped && stopped->surfaces.empty());

    // Each is drawn as if it were the scene's only one.
    frame.surface = 1;
    const std::optional<Picture> second = host->render(frame, error);
    ASSERT_TRUE(second) << error.text;
    Scene alone = *scene;
    alone.water = flat;
    ASSERT_TRUE(host->load(alone, error)) << error.text;
    EXPECT_FALSE(host->render(frame, error)) << "it has one water again";
    frame.surface = 0;
    const std::optional<Picture> only = host->render(frame, error);
    ASSERT_TRUE(only) << error.text;
    EXPECT_EQ(second->rgba, only->rgba);
    EXPECT_EQ(host->validationMessages(), 0u);
}

TEST_P(Surfaces, FloorsTakeTurnsOverOneScene) {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene("floor"), {}, error);
    ASSERT_TRUE(scene) << error.text;
    const std::unique_ptr<Host> host = Surfaces::host(error);
    ASSERT_TRUE(host) << error.text;
    // The first reads nothing of the scene, and must not leave the others without it.
    std::vector<FloorDesc> floors(3, *scene->floor);
    floors[0].reflection.reset();
    floors[1].reflection->technique = seaglass::ReflectionTechnique::sspr;
    floors[2].reflection->technique = seaglass::ReflectionTechnique::planar;
    const auto sceneWith = [&](const FloorDesc& floor) {
        Scene changed = *scene;
        changed.floor = floor;
        return changed;
    };
    ASSERT_TRUE(host->load(sceneWith(floors[0]), error) && host->addSurface(floors[1], error) &&
                host->addSurface(floors[2], error))
        << error.text;
    FrameDesc frame{160, 90, scene->cameras.front(), 0, Aov::color, 0};
    const std::optional<ComparedTimes> times = host->measureSurfaces(frame, 3, {}, error);
    ASSERT_TRUE(times) << error.text;
    ASSERT_EQ(times->surfaces.size(), 3u);
    const auto has = [&](size_t floor, const char* name) {
        return passOf(times->surfaces[floor], name).has_value();
    };
    for (size_t floor = 0; floor < 3; ++floor) {
        EXPECT_TRUE(has(floor, "host_opaque") && has(floor, "mirror_draw")) << floor;
        EXPECT_FALSE(has(floor, "simulate") || has(floor, "water_draw")) << floor;
        EXPECT_EQ(times->surfaces[floor].reflection.ms > 0, floor > 0);
        EXPECT_EQ(has(floor, "host_copy"), floor == 1) << "only sspr reads the scene";
        EXPECT_EQ(has(floor, "host_mirrored"), floor == 2);
    }
    EXPECT_EQ(times->surfaces[0].hostBytes, 0u);
    EXPECT_GE(times->surfaces[1].hostBytes, 160u * 90 * (8 + 4));
    EXPECT_GT(times->surfaces[2].hostBytes, 0u);
    EXPECT_LT(times->surfaces[2].hostBytes, 4096u) << "what is drawn into is the library's";
    const std::optional<uint64_t> bytes = host->reflectionBytes(floors[2], 160, 90, error);
    ASSERT_TRUE(bytes) << error.text;
    EXPECT_GE(*bytes, 160u * 90 * (8 + 2 + 4)) << "and the depth that is drawn into counts";

    // Each is drawn as if it were the scene's only one.
    std::vector<Picture> together;
    for (frame.surface = 0; frame.surface < 3; ++frame.surface) {
        const std::optional<Picture> picture = host->render(frame, error);
        ASSERT_TRUE(picture) << error.text;
        together.push_back(*picture);
    }
    EXPECT_NE(together[0].rgba, together[1].rgba);
    EXPECT_NE(together[1].rgba, together[2].rgba);
    frame.surface = 0;
    for (size_t floor = 0; floor < 3; ++floor) {
        ASSERT_TRUE(host->load(sceneWith(floors[floor]), error)) << error.text;
        const std::optional<Picture> alone = host->render(frame, error);
        ASSERT_TRUE(alone) << error.text;
        EXPECT_EQ(together[floor].rgba, alone->rgba) << floor;
    }
    EXPECT_EQ(host->validationMessages(), 0u);
}

INSTANTIATE_TEST_SUITE_P(ByEitherClock, Surfaces, testing::Values(PassClock::fence, PassClock::timestamps),
                         [](const auto& info) { return std::string(toString(info.param)); });

} // namespace
