#include "demos/tools/view/saved_view.h"

#include <gtest/gtest.h>

#include "tests/program/run.h"

namespace {

using demos::ViewState;

TEST(ViewState, TimePassesUnlessItIsPaused) {
    ViewState state;
    state.timeS = 5;
    state.timeScale = 2;
    demos::advance(state, {}, 0.25);
    EXPECT_EQ(state.timeS, 5.5);
    state.paused = true;
    demos::advance(state, {.forward = 1}, 0.25);
    EXPECT_EQ(state.timeS, 5.5);
    EXPECT_EQ(state.camera.positionM[2], -demos::flySpeedMps * 0.25) << "the camera still flies";
}

TEST(ViewState, WhoFliesLeavesTheCamerasPath) {
    ViewState state;
    state.camera.positionM = {0, 2, 0};
    state.camera.targetM = {0, 2, -10};
    state.camera.keyframes = {{.timeS = 4, .positionM = {8, 2, 0}, .targetM = {8, 2, -10}}};
    demos::advance(state, {}, 2);
    EXPECT_EQ(state.camera.keyframes.size(), 1u) << "it plays on";
    demos::advance(state, {.forward = 1}, 0.25);
    EXPECT_TRUE(state.camera.keyframes.empty());
    EXPECT_EQ(state.camera.positionM, (demos::Vec3{4, 2, -demos::flySpeedMps * 0.25}));
}

TEST(SavedView, IsTheScenesFirstCameraAndTime) {
    ViewState state;
    state.scene.cameras.resize(2);
    state.scene.cameras[0].name = "level";
    state.scene.cameras[1].name = "view";
    state.camera.name = "level";
    state.camera.positionM = {1, 2, 3};
    state.timeS = 7.5;
    const demos::Scene saved = demos::savedScene(state);
    EXPECT_EQ(saved.timeS, 7.5);
    ASSERT_EQ(saved.cameras.size(), 2u) << "the older view is gone";
    EXPECT_EQ(saved.cameras[0].name, "view");
    EXPECT_EQ(saved.cameras[0].positionM, (demos::Vec3{1, 2, 3}));
    EXPECT_EQ(saved.cameras[1].name, "level");
}

TEST(Split, TheRightHalfIsTheSameSurfaceMirroredOtherwise) {
    demos::Scene scene;
    demos::Split split;
    split.reflection.technique = seaglass::ReflectionTechnique::planar;
    EXPECT_FALSE(demos::otherSurface(scene, split));
    scene.water.emplace().levelM = 3;
    const std::optional<demos::SurfaceDesc> other = demos::otherSurface(scene, split);
    ASSERT_TRUE(other && std::holds_alternative<demos::WaterDesc>(*other));
    EXPECT_EQ(std::get<demos::WaterDesc>(*other).levelM, 3);
    EXPECT_EQ(std::get<demos::WaterDesc>(*other).reflection->technique,
              seaglass::ReflectionTechnique::planar);
    EXPECT_FALSE(scene.water->reflection) << "the left half keeps its own";
}

TEST(Split, LiesWithinThePicture) {
    EXPECT_EQ(demos::leftColumns({{}, 0.5}, 161), 81u);
    EXPECT_EQ(demos::leftColumns({{}, 0}, 160), 0u);
    EXPECT_EQ(demos::leftColumns({{}, 1.5}, 160), 160u);
}

TEST(SavedView, TakesNobodysName) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(demos::freeName(folder.path(), "lake", ".png"), folder.path() / "lake_0001.png");
    tests::writeAll(folder.path() / "lake_0001.png", "");
    tests::writeAll(folder.path() / "lake_0002.png", "");
    EXPECT_EQ(demos::freeName(folder.path(), "lake", ".png"), folder.path() / "lake_0003.png");
    EXPECT_EQ(demos::freeName(folder.path(), "lake", ".toml"), folder.path() / "lake_0001.toml");
}

} // namespace
