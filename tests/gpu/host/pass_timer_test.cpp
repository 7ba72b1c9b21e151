// The device's timestamps as the sample host and the benches read them.
#include <gtest/gtest.h>

#include "tests/gpu/rig/rig.h"

namespace {

using demos::TimedPass;

void run(const std::function<void(VkCommandBuffer, demos::PassTimer&)>& record) {
    demos::Error error;
    const bool done = tests::device().run(
        [&](VkCommandBuffer commands, demos::Error&) {
            record(commands, tests::device().passes());
            return true;
        },
        error);
    ASSERT_TRUE(done) << error.text;
}

std::vector<std::string> names(const std::vector<TimedPass>& passes) {
    std::vector<std::string> all;
    for (const TimedPass& pass : passes) all.push_back(pass.within + "/" + pass.name);
    return all;
}

TEST(PassTimer, KnowsWhichPassIsWithinWhich) {
    run([](VkCommandBuffer commands, demos::PassTimer& timer) {
        timer.mark(commands, "a", true);
        for (int i = 0; i < 2; ++i) {
            timer.mark(commands, "b", true);
            timer.mark(commands, "b", false);
        }
        timer.mark(commands, "a", false);
        timer.mark(commands, "b", true);
        timer.mark(commands, "b", false);
    });
    std::vector<TimedPass> passes;
    demos::Error error;
    ASSERT_TRUE(tests::device().passes().collect(passes, error)) << error.text;
    EXPECT_EQ(names(passes), (std::vector<std::string>{"/a", "a/b", "/b"})) << "repeats are summed";
    EXPECT_LE(demos::sumWithin(passes, "a"), demos::msOf(passes, "a"));
    EXPECT_EQ(tests::device().passes().unfinished(), "") << "all have ended";
}

TEST(PassTimer, NamesWhatHasNotEnded) {
    run([](VkCommandBuffer commands, demos::PassTimer& timer) {
        timer.mark(commands, "a", true);
        timer.mark(commands, "b", true);
        timer.mark(commands, "b", false);
        timer.mark(commands, "c", true);
    });
    EXPECT_EQ(tests::device().passes().unfinished(), "c (a)") << "the innermost, b is over";
    run([](VkCommandBuffer commands, demos::PassTimer& timer) {
        timer.mark(commands, "a", true);
        timer.mark(commands, "b", true);
        timer.mark(commands, "b", false);
    });
    EXPECT_EQ(tests::device().passes().unfinished(), "a");
    run([](VkCommandBuffer, demos::PassTimer&) {});
    EXPECT_EQ(tests::device().passes().unfinished(), "") << "forgotten";
}

TEST(PassTimer, SaysThatThereWereTooMany) {
    run([](VkCommandBuffer commands, demos::PassTimer& timer) {
        for (int i = 0; i < 300; ++i) {
            timer.mark(commands, "a", true);
            timer.mark(commands, "a", false);
        }
    });
    std::vector<TimedPass> passes;
    demos::Error error;
    EXPECT_FALSE(tests::device().passes().collect(passes, error));
    EXPECT_EQ(error.text, "more than 256 passes in one submission");
}

} // namespace
