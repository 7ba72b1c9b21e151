// demos/tutorial: the renderer before it has water, with water.diff, and after mirrors.diff.
#include <gtest/gtest.h>

#include "demos/host/image_file.h"
#include "demos/metrics/compare.h"
#include "tests/program/run.h"
#include "tests/visual/limits.h"

namespace {

namespace fs = std::filesystem;

constexpr uint32_t width = 256, height = 144;

/// Draws under validation, which may have nothing to say.
std::vector<uint8_t> draw(const fs::path& program) {
    const tests::TemporaryFolder folder;
    const tests::Outcome outcome = tests::run(
        program, {{"picture.ppm", std::to_string(width), std::to_string(height)},
                  {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                   {"VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}},
                  folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "validation";
    EXPECT_EQ(outcome.err, "");
    const std::string ppm = tests::readAll(folder.path() / "picture.ppm"), header = "P6 256 144 255\n";
    EXPECT_EQ(ppm.substr(0, header.size()), header);
    std::vector<uint8_t> rgb(ppm.begin() + static_cast<ptrdiff_t>(std::min(header.size(), ppm.size())),
                             ppm.end());
    rgb.resize(size_t{3} * width * height);
    return rgb;
}

struct Box {
    uint32_t left, top, right, bottom;
};

/// Means of red, green and blue.
std::array<double, 3> mean(const std::vector<uint8_t>& rgb, const Box& box) {
    std::array<double, 3> sums{};
    for (uint32_t y = box.top; y < box.bottom; ++y)
        for (uint32_t x = box.left; x < box.right; ++x)
            for (size_t c = 0; c < 3; ++c) sums[c] += rgb[3 * (size_t{y} * width + x) + c];
    for (double& sum : sums) sum /= (box.right - box.left) * (box.bottom - box.top);
    return sums;
}

demos::Image view(const demos::Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

TEST(Tutorial, GainsWater) {
    const std::vector<uint8_t> before = draw(SEAGLASS_BEFORE), first = draw(SEAGLASS_FIRST),
                               after = draw(SEAGLASS_AFTER);
    const Box sky{10, 5, 60, 20}, bed{60, 110, 200, 140};
    const auto sand = mean(before, bed), opaque = mean(first, bed), clear = mean(after, bed);
    EXPECT_GT(sand[0], sand[2] + 20) << "sand is yellow";
    for (const auto& [drawn, water] : {std::pair(first, opaque), {after, clear}}) {
        EXPECT_EQ(mean(before, sky), mean(drawn, sky)) << "what is not water stays as it was";
        EXPECT_GT(water[2], water[0]) << "water is blue";
    }
    EXPECT_GT(clear[0], opaque[0] + 10) << "sand shines through what mirrors.diff lets light into";
}

TEST(Tutorial, IsAsApproved) {
    const std::vector<uint8_t> rgb = draw(SEAGLASS_AFTER);
    const fs::path png = fs::path(SEAGLASS_ACTUAL) / "tutorial_water.png";
    fs::create_directories(SEAGLASS_ACTUAL);
    demos::Error error;
    ASSERT_TRUE(demos::writePng(png, width, height, rgb, error)) << error.text;
    const auto expected = demos::readPicture(SEAGLASS_GOLDEN, error);
    ASSERT_TRUE(expected) << error.text << "; the picture to approve is " << png;
    const auto actual = demos::readPicture(png, error);
    ASSERT_TRUE(actual) << error.text;
    const demos::Limits limits = tests::goldenLimits();
    const std::vector<std::string> objections = demos::objections(
        demos::compare(view(*expected), view(*actual), demos::PictureKind::display, limits), limits);
    for (const std::string& objection : objections) ADD_FAILURE() << objection << "; see " << png;
}

} // namespace
