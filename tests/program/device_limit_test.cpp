// Pictures that are larger than a device's images can be.
#include <gtest/gtest.h>

#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

class SmallDevice : public testing::Test {
  protected:
    SmallDevice() { tests::writeSample(folder_.path()); }

    tests::Outcome run(const std::vector<std::string>& arguments) const {
        return tests::run(SEAGLASS_PROGRAM, {arguments,
                                             {{"VK_LAYER_PATH", SEAGLASS_LAYERS},
                                              {"VK_INSTANCE_LAYERS", "VK_LAYER_SEAGLASS_small_device"}},
                                             folder_.path()});
    }
    void expectRefused(const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
        const std::vector<std::string> before = tests::namesIn(folder_.path());
        tests::expectRefused(run(arguments), words);
        EXPECT_EQ(tests::namesIn(folder_.path()), before);
        EXPECT_TRUE(tests::namesIn(folder_.path() / "out").empty());
    }

    tests::TemporaryFolder folder_;
};

TEST_F(SmallDevice, RefusesLargePictures) {
    expectRefused({"render", "scene.toml", "-o", "out/a.png", "--no-validation", "--size", "4097x9"},
                  {"--size is '4097x9'", "at most 4096 pixels a side"});
    expectRefused({"render", "scene.toml", "-o", "out/a.png", "--no-validation", "--size", "9x2049",
                   "--supersample", "2"},
                  {"--size is '9x2049' and --supersample is '2'", "at most 4096 pixels a side"});
    expectRefused({"measure", "scene.toml", "-o", "new", "--quick", "--size", "9x4097"},
                  {"--size is '9x4097'", "at most 4096 pixels a side"});
}

TEST_F(SmallDevice, DrawsTheLargestItHas) {
    const tests::Outcome outcome =
        run({"render", "scene.toml", "-o", "out/a.png", "--no-validation", "--size", "4096x4"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

} // namespace
