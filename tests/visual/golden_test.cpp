// Renders what goldens.txt lists and compares it with the pictures in golden/, which scripts/goldens renews.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "demos/tools/metrics/finite.h"
#include "tests/program/run.h"
#include "tests/visual/limits.h"

namespace {

namespace fs = std::filesystem;

struct Golden {
    std::string scene, camera, size;
    std::string quality, samples; // empty where goldens.txt ends before them

    std::string name() const { return scene + "_" + camera + (quality.empty() ? "" : "_" + quality); }

    std::vector<std::string> options() const {
        std::vector<std::string> all = {"--camera", camera, "--size", size};
        if (!samples.empty()) all.insert(all.end(), {"--supersample", samples});
        if (!quality.empty() && quality != "own") all.insert(all.end(), {"--quality", quality});
        return all;
    }
};

void PrintTo(const Golden& golden, std::ostream* out) {
    *out << golden.name();
}

std::vector<Golden> listGoldens() {
    std::vector<Golden> goldens;
    std::ifstream file(SEAGLASS_SOURCE "/tests/visual/goldens.txt");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        Golden golden;
        if (line.starts_with('#') || !(words >> golden.scene >> golden.camera >> golden.size)) continue;
        words >> golden.quality >> golden.samples;
        goldens.push_back(golden);
    }
    return goldens;
}

demos::PixelView view(const demos::Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

class GoldenPicture : public testing::TestWithParam<Golden> {
  protected:
    GoldenPicture() { fs::create_directories(folder_); }

    fs::path file(const std::string& ending) const { return folder_ / (GetParam().name() + ending); }

    const fs::path folder_ = SEAGLASS_ACTUAL;
};

TEST_P(GoldenPicture, IsAsApproved) {
    const Golden& golden = GetParam();
    const fs::path approved = fs::path(SEAGLASS_SOURCE) / "tests/visual/golden" / (golden.name() + ".png");
    const fs::path actualPng = file(".png"), actualExr = file(".exr"), report = file("_report");
    fs::remove_all(report);

    // lavapipe, because it is everywhere: another device's pictures are as good, but not the same.
    const std::string scene = SEAGLASS_SOURCE "/demos/scenes/" + golden.scene + ".toml";
    std::vector<std::string> command = {"render",           scene,      "-o",       actualPng.string(), "-o",
                                        actualExr.string(), "--device", "llvmpipe", "--validation"};
    const std::vector<std::string> options = golden.options();
    command.insert(command.end(), options.begin(), options.end());
    const tests::Outcome outcome = tests::run(SEAGLASS_PROGRAM, {command});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");

    demos::Error error;
    const auto linear = demos::readPicture(actualExr, error);
    ASSERT_TRUE(linear) << error.text;
    EXPECT_EQ(demos::countNotFinite(view(*linear)), 0u) << actualExr;

    const auto actual = demos::readPicture(actualPng, error);
    ASSERT_TRUE(actual) << error.text;
    const auto expected = demos::readPicture(approved, error);
    ASSERT_TRUE(expected) << error.text << "; the picture to approve is " << actualPng;
    const demos::Limits limits = tests::goldenLimits();
    const demos::Comparison comparison =
        demos::compare(view(*expected), view(*actual), demos::PictureKind::display, limits);
    const std::vector<std::string> objections = demos::objections(comparison, limits);
    if (objections.empty()) return;
    tests::run(SEAGLASS_PROGRAM,
               {{"compare", approved.string(), actualPng.string(), "--report", report.string()}});
    std::string list;
    for (const std::string& objection : objections) list += objection + "\n  ";
    FAIL() << list << "golden: " << approved << "\n  actual: " << actualPng
           << "\n  both:   " << report / "index.html"
           << "\n  If the change is meant, look at both and see scripts/goldens.";
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenPicture, testing::ValuesIn(listGoldens()),
                         [](const testing::TestParamInfo<Golden>& info) { return info.param.name(); });

TEST(Goldens, AreListed) {
    EXPECT_GE(listGoldens().size(), 4u);
}

} // namespace
