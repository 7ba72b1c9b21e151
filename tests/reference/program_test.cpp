// seaglass reference, from the command line.
#include <gtest/gtest.h>

#include "host/files/image_file.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

namespace fs = std::filesystem;
using tests::Outcome;

class Reference : public testing::Test {
  protected:
    Reference() { tests::writeSample(folder_.path()); }

    /// Traces the sample small, into out/.
    Outcome trace(const std::vector<std::string>& more, size_t largestFile = 0) {
        std::vector<std::string> arguments = {"reference", "scene.toml", "--size", "32x18"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        // No Vulkan driver is there, and none is needed.
        return tests::run(SEAGLASS_PROGRAM,
                          {arguments, {{"VK_ICD_FILENAMES", "/nowhere"}}, folder_.path(), largestFile});
    }
    fs::path out(const std::string& name) const { return folder_.path() / "out" / name; }
    std::vector<std::string> outputs() const { return tests::namesIn(folder_.path() / "out"); }

    tests::TemporaryFolder folder_;
};

TEST_F(Reference, WritesPicturesAndTruthWithoutADevice) {
    const Outcome outcome = trace({"-o", "out/a.png", "-o", "out/b.exr", "--truth", "out/c.exr", "--mirrored",
                                   "out/d.exr", "--spp", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "progress is for terminals";
    EXPECT_EQ(outputs(), (std::vector<std::string>{"a.png", "b.exr", "c.exr", "d.exr"}));
    EXPECT_NE(outcome.out.find("32x18, 2 samples a pixel"), std::string::npos) << outcome.out;
    demos::Error error;
    const std::optional<demos::Picture> truth = demos::readPicture(out("c.exr"), error);
    ASSERT_TRUE(truth) << error.text;
    const std::optional<demos::Picture> mirrored = demos::readPicture(out("d.exr"), error);
    ASSERT_TRUE(mirrored) << error.text;
    size_t sky = 0;
    for (size_t i = 0; i < truth->rgba.size(); i += 4) {
        sky += truth->rgba[i] == 1 ? 1 : 0;
        EXPECT_EQ(mirrored->rgba[i + 2] > 0, truth->rgba[i] > 0) << "black where nothing mirrors";
    }
    EXPECT_GT(sky, 50u);
}

TEST_F(Reference, WhatIsMirroredCanBeHadAlone) {
    ASSERT_EQ(trace({"-o", "out/a.png", "--mirrored", "out/b.exr"}).code, 0);
    ASSERT_EQ(trace({"-o", "out/a.png", "--truth", "out/c.exr", "--mirrored", "out/d.exr"}).code, 0);
    EXPECT_TRUE(tests::readAll(out("b.exr")) == tests::readAll(out("d.exr")));
}

TEST_F(Reference, SeedTimeAndSamplesShow) {
    std::vector<std::string> pictures;
    const std::vector<std::vector<std::string>> variants = {{"--spp", "2"},
                                                            {"--spp", "2"},
                                                            {"--spp", "2", "--seed", "5"},
                                                            {"--spp", "3"},
                                                            {"--spp", "2", "--time", "9"}};
    for (const auto& variant : variants) {
        std::vector<std::string> arguments = {"-o", "out/a.exr"};
        arguments.insert(arguments.end(), variant.begin(), variant.end());
        ASSERT_EQ(trace(arguments).code, 0);
        pictures.push_back(tests::readAll(out("a.exr")));
    }
    EXPECT_TRUE(pictures[1] == pictures[0]);
    for (size_t i = 2; i < pictures.size(); ++i)
        EXPECT_FALSE(pictures[i] == pictures[0]) << variants[i].back();
}

TEST_F(Reference, AnotherSkyBringsItsOwnSun) {
    // One bright pixel in a dim sky.
    std::string sky = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    for (int i = 0; i < 64 * 32; ++i) sky += i == 10 * 64 + 50 ? "\x80\x80\x80\x88" : "\x40\x40\x40\x7c";
    tests::writeAll(folder_.path() / "mine.hdr", sky);
    const auto traced = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"-o", "out/a.exr", "--spp", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = trace(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return tests::readAll(out("a.exr"));
    };
    const std::string own = traced({"--sky", "mine.hdr"});
    EXPECT_TRUE(own == traced({"--sky", "mine.hdr", "--set", "sun.from_sky=true"}));
    EXPECT_FALSE(own == traced({"--sky", "mine.hdr", "--set", "sun.from_sky=false"}))
        << "the line's goes first";
    EXPECT_FALSE(own == traced({"--sky", "mine.hdr", "--set", "sun.elevation_deg=20"}));
}

TEST_F(Reference, BadInputIsNamed) {
    const auto expect = [&](const std::vector<std::string>& arguments, const std::string& said) {
        const Outcome outcome = trace(arguments);
        EXPECT_EQ(outcome.code, 2) << said;
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(tests::countLines(outcome.err), 1u) << outcome.err;
        EXPECT_TRUE(outputs().empty());
    };
    expect({}, "no output");
    expect({"-o", "out/a.jpg"}, "expected .png or .exr");
    expect({"-o", "out/a.png", "--spp", "0"}, "--spp is '0', expected a whole number");
    expect({"-o", "out/a.png", "--seed", "-1"}, "--seed is '-1'");
    expect({"-o", "out/a.png", "--truth", "out/b.png"}, "expected .exr");
    expect({"-o", "out/a.exr", "--truth", "out/a.exr"}, "--truth out/a.exr: is another output as well");
    expect({"-o", "out/a.png", "--mirrored", "out/b.png"}, "--mirrored out/b.png: '.png'");
    expect({"-o", "out/a.png", "--truth", "out/b.exr", "--mirrored", "out/b.exr"},
           "--mirrored out/b.exr: is another output as well");
    expect({"-o", "out/a.png", "--camera", "lov"}, "the nearest is low");
    expect({"-o", "out/a.png", "--aov", "height"}, "--aov is not known");
    tests::writeAll(folder_.path() / "tetra.gltf", "{}");
    expect({"-o", "out/a.png"}, "mesh.0.file");
}

TEST_F(Reference, AFullDiskFailsTheRun) {
    const Outcome outcome = trace({"-o", "out/a.exr"}, 200);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("a.exr"), std::string::npos) << outcome.err;
    EXPECT_TRUE(outputs().empty());
}

} // namespace
