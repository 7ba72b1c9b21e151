// seaglass view as a process of its own: what it shows, and what it says when it cannot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/host/files/image_file.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"
#include "tests/view/xvfb.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;
using Names = std::vector<std::string>;

class View : public testing::Test {
  protected:
    View() { tests::writeSample(folder_.path()); }

    Outcome run(const std::string& command, const Names& more, const std::string& display = "",
                std::map<std::string, std::string> settings = {}) {
        Names arguments = {command, "scene.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        settings.merge(std::map<std::string, std::string>{{"DISPLAY", display}, {"WAYLAND_DISPLAY", ""}});
        return tests::run(SEAGLASS_PROGRAM, {arguments, settings, folder_.path()});
    }
    fs::path out(const std::string& name) const { return folder_.path() / "out" / name; }

    tests::TemporaryFolder folder_;
};

#if SEAGLASS_VIEWER

class ViewOnDisplay : public View {
  protected:
    /// Shows the sample without its panel, as it is measured.
    Outcome view(const Names& more) {
        Names arguments = {"--size", "160x90", "--no-ui", "--validation", "--plain"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run("view", arguments, xvfb_.display());
    }

    /// On a device that goes wrong.
    void expectEnds(std::map<std::string, std::string> settings, const std::string& words) {
        settings["VK_LAYER_PATH"] = SEAGLASS_LAYERS;
        settings["VK_INSTANCE_LAYERS"] = "VK_LAYER_SEAGLASS_lost_device";
        const Outcome outcome =
            run("view", {"--size", "32x18", "--no-ui", "--frames", "2", "--dt", "0.25", "--no-validation"},
                xvfb_.display(), settings);
        EXPECT_EQ(outcome.code, 1) << outcome.err;
        EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }

    /// The greatest difference of any channel of any pixel of some columns, in 255ths.
    double difference(const std::string& a, const std::string& b, size_t first = 0, size_t end = 160) const {
        demos::Error error;
        const std::optional<demos::Picture> one = demos::readPicture(out(a), error);
        const std::optional<demos::Picture> other = demos::readPicture(out(b), error);
        if (!one || !other || one->width != other->width || one->height != other->height) return 255;
        float most = 0;
        for (size_t i = 0; i < one->rgba.size(); ++i) {
            const size_t column = i / 4 % one->width;
            if (column >= first && column < end)
                most = std::max(most, std::abs(one->rgba[i] - other->rgba[i]));
        }
        return 255 * static_cast<double>(most);
    }

    tests::Xvfb xvfb_;
};

TEST_F(ViewOnDisplay, ShowsWhatRenderDraws) {
    REQUIRE_DISPLAY(xvfb_);
    const Outcome viewed = view({"--frames", "3", "--dt", "0.25", "--screenshot", "out/view.png"});
    ASSERT_EQ(viewed.code, 0) << viewed.err;
    EXPECT_EQ(viewed.out + viewed.err, "");
    const Outcome rendered =
        run("render", {"--size", "160x90", "--plain", "--frames", "3", "--fps", "4", "-o", "out/%d.png"});
    ASSERT_EQ(rendered.code, 0) << rendered.err;
    EXPECT_LE(difference("view.png", "2.png"), 1.01);
    EXPECT_GT(difference("0.png", "2.png"), 10) << "the waves move";
}

TEST_F(ViewOnDisplay, ShowsThroughAirAndLensUnlessPlain) {
    REQUIRE_DISPLAY(xvfb_);
    const Names shown = {"--frames", "3", "--dt", "0", "--screenshot"};
    Names plain = shown, seen = {"--size", "160x90", "--no-ui", "--validation"};
    plain.push_back("out/plain.png");
    seen.insert(seen.end(), shown.begin(), shown.end());
    seen.push_back("out/seen.png");
    ASSERT_EQ(view(plain).code, 0);
    const Outcome viewed = run("view", seen, xvfb_.display());
    ASSERT_EQ(viewed.code, 0) << viewed.err;
    const double most = difference("seen.png", "plain.png");
    EXPECT_GT(most, 3) << "edges are soft";
}

TEST_F(ViewOnDisplay, ShowsOutputsAsRenderDoes) {
    REQUIRE_DISPLAY(xvfb_);
    for (const char* aov : {"class", "normal", "foam", "overlay_classes"}) {
        const Outcome viewed =
            view({"--frames", "1", "--dt", "0", "--screenshot", "out/view.png", "--aov", aov});
        ASSERT_EQ(viewed.code, 0) << viewed.err;
        ASSERT_EQ(run("render", {"--size", "160x90", "-o", "out/a.png", "--aov", aov}).code, 0);
        EXPECT_LE(difference("view.png", "a.png"), 1.01) << aov;
    }
}

TEST_F(ViewOnDisplay, SplitMirrorsTheHalvesByTheirOwnTechniques) {
    REQUIRE_DISPLAY(xvfb_);
    const Outcome viewed = view(
        {"--frames", "1", "--dt", "0", "--aov", "class", "--screenshot", "out/view.png", "--split", "sky"});
    ASSERT_EQ(viewed.code, 0) << viewed.err;
    const Names asViewed = {"--size", "160x90", "--aov", "class", "-o"};
    Names left = asViewed, right = asViewed;
    left.push_back("out/left.png");
    right.insert(right.end(), {"out/right.png", "--set", "water.reflection.technique=sky"});
    ASSERT_EQ(run("render", left).code, 0);
    ASSERT_EQ(run("render", right).code, 0);
    EXPECT_LE(difference("view.png", "left.png", 0, 80), 1.01);
    EXPECT_LE(difference("view.png", "right.png", 80, 160), 1.01);
    EXPECT_GT(difference("left.png", "right.png", 0, 80), 100) << "the techniques differ on both sides";
    EXPECT_GT(difference("left.png", "right.png", 80, 160), 100);
}

TEST_F(ViewOnDisplay, SplitAgainstTheReferenceShowsItsSamples) {
    REQUIRE_DISPLAY(xvfb_);
    const Outcome viewed = view({"--frames", "2", "--dt", "0.25", "--screenshot", "out/view.png", "--split",
                                 "reference", "--spp", "3"});
    ASSERT_EQ(viewed.code, 0) << viewed.err;
    const Names still = {"--size", "160x90", "--plain", "--time", "1.75", "-o"};
    Names left = still, right = still;
    left.push_back("out/left.png");
    right.insert(right.end(), {"out/right.png", "--spp", "3"});
    ASSERT_EQ(run("render", left).code, 0);
    ASSERT_EQ(run("reference", right).code, 0);
    EXPECT_LE(difference("view.png", "left.png", 0, 80), 1.01);
    EXPECT_LE(difference("view.png", "right.png", 80, 160), 1.01);
    EXPECT_GT(difference("left.png", "right.png", 80, 160), 10) << "they differ";
}

TEST_F(ViewOnDisplay, PausedItStandsStill) {
    REQUIRE_DISPLAY(xvfb_);
    const Names still = {"--dt", "0.25", "--paused", "--frames"};
    const auto shown = [&](const char* frames, const char* file) {
        Names arguments = still;
        arguments.insert(arguments.end(), {frames, "--screenshot", file});
        return view(arguments).code;
    };
    ASSERT_EQ(shown("1", "out/one.png"), 0);
    ASSERT_EQ(shown("4", "out/four.png"), 0);
    EXPECT_EQ(difference("one.png", "four.png"), 0);
}

TEST_F(ViewOnDisplay, AHungPassIsNamedAndNotWaitedFor) {
    REQUIRE_DISPLAY(xvfb_);
    const std::string there = (folder_.path() / "scene.toml").string();
    expectEnds({{"SEAGLASS_LOST_ONCE", there}, {"SEAGLASS_LOST_AFTER", "2"}, {"SEAGLASS_LOST_HOW", "hung"}},
               " hung in simulate (frame): not done after ");
}

TEST_F(ViewOnDisplay, ADisplayThatTakesNoFrameIsNotWaitedForForEver) {
    REQUIRE_DISPLAY(xvfb_);
    expectEnds({{"SEAGLASS_NO_IMAGE", "1"}}, "the display took no frame of the window for ");
}

TEST_F(View, WithoutADisplayItNamesRender) {
    tests::expectRefused(run("view", {}), {"display", "$DISPLAY", "seaglass render"});
    tests::expectRefused(run("view", {}, ":9999"), {":9999", "seaglass render"});
}

#else

TEST_F(View, LeftOutItSaysWhatItNeeds) {
    tests::expectRefused(run("view", {}), {"libglfw3-dev", "libimgui-dev", "seaglass render"});
}

#endif

TEST_F(View, RefusesBadInput) {
    tests::expectRefused(tests::run(SEAGLASS_PROGRAM, {{"view"}}), {"no scene", "seaglass view SCENE.toml"});
    tests::expectRefused(run("view", {"--frames", "0"}), {"--frames", "'0'"});
    tests::expectRefused(run("view", {"--dt", "-1"}), {"--dt", "'-1'", "0 to 10"});
    tests::expectRefused(run("view", {"--screenshot", "a.png"}), {"--screenshot", "--frames"});
    tests::expectRefused(run("view", {"--frames", "1", "--screenshot", "a.exr"}), {"--screenshot", ".png"});
    tests::expectRefused(run("view", {"--aov", "depth"}), {"--aov", "'depth'", "seaglass render"});
    tests::expectRefused(run("view", {"--aov", "clas"}), {"--aov", "'clas'", "class"});
    tests::expectRefused(run("view", {"--split", "plane"}), {"--split", "'plane'", "planar"});
    tests::expectRefused(run("view", {"--split", "referense"}), {"--split", "nearest is reference"});
    tests::expectRefused(run("view", {"--split", "reference", "--aov", "class"}), {"reference", "--aov"});
    tests::expectRefused(run("view", {"--spp", "4"}), {"--spp", "--split reference"});
    tests::expectRefused(run("view", {"--split", "reference", "--spp", "0"}), {"--spp", "'0'"});
    tests::expectRefused(run("view", {"--sise", "1x1"}), {"--sise", "--size"});
}

#if SEAGLASS_VIEWER
TEST_F(View, RefusesScenesAsRenderDoes) {
    tests::expectRefused(run("view", {"--camera", "lo"}), {"--camera", "'lo'", "low"});
    tests::expectRefused(run("view", {"--set", "water.waves.wind_m_s=-3"}), {"wind_m_s", "-3", "0 to 100"});
    tests::expectRefused(tests::run(SEAGLASS_PROGRAM, {{"view", "missing.toml"}}), {"missing.toml"});
}
#endif

} // namespace
