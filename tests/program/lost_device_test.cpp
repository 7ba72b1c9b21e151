// Devices that are lost or hang, and drivers that take their time.
#include <gtest/gtest.h>

#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;
using Settings = std::map<std::string, std::string>;

class LostDevice : public testing::Test {
  protected:
    LostDevice() { tests::writeSample(folder_.path()); }

    Outcome run(const std::vector<std::string>& arguments, Settings settings) const {
        settings["VK_LAYER_PATH"] = SEAGLASS_LAYERS;
        settings["VK_INSTANCE_LAYERS"] = "VK_LAYER_SEAGLASS_lost_device";
        return tests::run(SEAGLASS_PROGRAM, {arguments, settings, folder_.path()});
    }
    Outcome render(Settings settings) const {
        return run({"render", "scene.toml", "-o", "out/a.png", "--frames", "2", "--size", "32x18",
                    "--no-validation"},
                   std::move(settings));
    }
    /// The second picture's, from a timestamp on.
    Settings lostAfter(const char* timestamps, const char* how) const {
        return {{"SEAGLASS_LOST_ONCE", (folder_.path() / "out/a_0000.png").string()},
                {"SEAGLASS_LOST_AFTER", timestamps},
                {"SEAGLASS_LOST_HOW", how}};
    }
    static void expectFailed(const Outcome& outcome, const std::vector<std::string>& words) {
        EXPECT_EQ(outcome.code, 1) << outcome.err;
        EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
        for (const std::string& word : words) {
            EXPECT_NE(outcome.err.find(word), std::string::npos)
                << "'" << word << "' is not in: " << outcome.err;
        }
    }

    tests::TemporaryFolder folder_;
};

TEST_F(LostDevice, NamesThePassAndKeepsWhatIsFinished) {
    // The frame and its simulation had begun, and the first pass of that.
    expectFailed(render(lostAfter("3", "lost")), {" was lost in waves", " (simulate)"});
    EXPECT_EQ(tests::namesIn(folder_.path() / "out"), std::vector<std::string>{"a_0000.png"});
}

TEST_F(LostDevice, AHungOneIsNotWaitedFor) {
    expectFailed(render(lostAfter("2", "hung")), {" hung in simulate (frame)", "not done after"});
    EXPECT_EQ(tests::namesIn(folder_.path() / "out"), std::vector<std::string>{"a_0000.png"});
}

TEST_F(LostDevice, AHungOneThatIsLostInTheEndIsNamedByWhereItWasSeen) {
    expectFailed(render(lostAfter("3", "later")),
                 {" was lost in waves", " (simulate), where it was last seen"});
}

TEST_F(LostDevice, WhereNothingIsToldTheSubmissionIsNamed) {
    expectFailed(render(lostAfter("3", "mute")), {" was lost in frame; the device no longer tells in which"});
}

TEST_F(LostDevice, WithoutATimestampNoPassIsNamed) {
    expectFailed(render(lostAfter("0", "lost")), {" was lost in no pass that is known"});
}

TEST_F(LostDevice, MeasureKeepsTheViewsBefore) {
    const Outcome outcome =
        run({"measure", "scene.toml", "-o", "new", "--technique", "sspr", "--size", "32x18", "--rounds", "1"},
            {{"SEAGLASS_LOST_ONCE", (folder_.path() / "new/index.html").string()},
             {"SEAGLASS_LOST_AFTER", "1"},
             {"SEAGLASS_LOST_HOW", "lost"}});
    expectFailed(outcome, {" was lost in host_shadow", "1 of 2 views measured, see ", "index.html"});
    EXPECT_TRUE(fs::exists(folder_.path() / "new/tradeoff.json"));
}

TEST_F(LostDevice, ASlowPipelineIsNamed) {
    const Outcome outcome =
        run({"render", "scene.toml", "-o", "out/a.png", "--size", "32x18", "--no-validation"},
            {{"SEAGLASS_SLOW_DRIVER", "1"}});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: water: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("the driver compiled it for 11 s"), std::string::npos) << outcome.err;
}

} // namespace
