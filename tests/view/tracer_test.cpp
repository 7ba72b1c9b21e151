// The reference on a thread of its own: what it brings, and what it throws away.
#include "demos/tools/view/tracer.h"

#include <gtest/gtest.h>

#include "tests/program/sample.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t samples = 2;

class Traced : public testing::Test {
  protected:
    void SetUp() override {
        tests::writeSample(folder_.path());
        const std::optional<Scene> read = loadScene(folder_.path() / "scene.toml", {}, error);
        ASSERT_TRUE(read) << error.text;
        scene = *read;
        view = {48, 32, scene.cameras.front(), scene.timeS};
    }
    /// The picture that is there once all has come.
    TracedPicture finished(Tracer& tracer) {
        tracer.wait();
        std::optional<TracedPicture> come;
        EXPECT_TRUE(tracer.take(come, error)) << error.text;
        EXPECT_TRUE(come);
        return come.value_or(TracedPicture{});
    }
    /// What `seaglass reference` draws.
    Picture expected(const TracedView& of) {
        return tests::traced(scene, {of.width, of.height, of.camera, of.timeS, samples}).color;
    }

    tests::TemporaryFolder folder_;
    Scene scene;
    TracedView view;
    Error error;
};

TEST_F(Traced, BringsTheReference) {
    Tracer tracer(samples);
    tracer.setScene(scene, false);
    tracer.look(view);
    const TracedPicture come = finished(tracer);
    EXPECT_EQ(come.samples, samples);
    EXPECT_TRUE(come.picture.rgba == expected(view).rgba);
    std::optional<TracedPicture> again;
    EXPECT_TRUE(tracer.take(again, error));
    EXPECT_FALSE(again) << "taken once";
}

TEST_F(Traced, ThrowsAwayWhatIsSeenNoMore) {
    Tracer tracer(samples);
    tracer.setScene(scene, false);
    tracer.look(view);
    tracer.wait();
    std::optional<TracedPicture> come;
    tracer.look(std::nullopt);
    EXPECT_TRUE(tracer.take(come, error));
    EXPECT_FALSE(come) << "what was traced goes with the view";

    TracedView higher = view;
    higher.camera.positionM[1] += 1;
    tracer.look(view);
    tracer.look(higher);
    EXPECT_TRUE(finished(tracer).picture.rgba == expected(higher).rgba);
}

TEST_F(Traced, FollowsTheScene) {
    Tracer tracer(samples);
    tracer.setScene(scene, false);
    tracer.look(view);
    const Picture before = finished(tracer).picture;
    scene.water->waves->beaufort = 7;
    tracer.setScene(scene, true);
    const Picture stormy = finished(tracer).picture;
    EXPECT_FALSE(stormy.rgba == before.rgba);
    EXPECT_TRUE(stormy.rgba == expected(view).rgba);
    scene.sun.elevationDeg = 60;
    tracer.setScene(scene, false);
    EXPECT_TRUE(finished(tracer).picture.rgba == expected(view).rgba);
}

TEST_F(Traced, SaysWhatCannotBeTracedAndGoesOn) {
    Tracer tracer(samples);
    const std::filesystem::path sky = scene.sky.file;
    scene.sky.file = "missing.hdr";
    tracer.setScene(scene, false);
    tracer.look(view);
    tracer.wait();
    std::optional<TracedPicture> come;
    EXPECT_FALSE(tracer.take(come, error));
    EXPECT_NE(error.text.find("missing.hdr"), std::string::npos) << error.text;
    EXPECT_TRUE(tracer.take(come, error)) << "it is said once";
    scene.sky.file = sky;
    tracer.setScene(scene, true);
    EXPECT_EQ(finished(tracer).samples, samples);
}

} // namespace
