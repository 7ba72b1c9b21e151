// demos/tutorial: the renderer before it has water, and after each of its steps.
#include <gtest/gtest.h>

#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;

constexpr uint32_t width = 256, height = 144;

/// Draws a picture under validation, which may have nothing to say. RGB, without its header.
std::vector<uint8_t> draw(const fs::path& program, const std::vector<std::string>& size,
                          const std::string& header) {
    const tests::TemporaryFolder folder;
    std::vector<std::string> arguments = {"picture.ppm"};
    arguments.insert(arguments.end(), size.begin(), size.end());
    const tests::Outcome outcome = tests::run(
        program, {arguments,
                  {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                   {"VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}},
                  folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "validation";
    EXPECT_EQ(outcome.err, "");
    const std::string ppm = tests::readAll(folder.path() / "picture.ppm");
    EXPECT_EQ(ppm.substr(0, header.size()), header);
    std::vector<uint8_t> rgb(ppm.begin() + static_cast<ptrdiff_t>(std::min(header.size(), ppm.size())),
                             ppm.end());
    return rgb;
}

/// A step of demos/tutorial.
std::vector<uint8_t> draw(const char* step) {
    std::vector<uint8_t> rgb = draw(fs::path(SEAGLASS_STATES) / step / "build/tutorial",
                                    {std::to_string(width), std::to_string(height)}, "P6 256 144 255\n");
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

constexpr Box sky{10, 5, 60, 20}, near{60, 110, 200, 140}, lighthouse{64, 91, 80, 122};

double brightness(const std::vector<uint8_t>& rgb, const Box& box) {
    const auto [red, green, blue] = mean(rgb, box);
    return (red + green + blue) / 3;
}

/// Mean difference of channels.
double change(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b, const Box& box) {
    std::vector<uint8_t> apart(a.size());
    for (size_t i = 0; i < a.size(); ++i) apart[i] = static_cast<uint8_t>(std::abs(a[i] - b[i]));
    return brightness(apart, box);
}

TEST(Tutorial, GainsASeaInItsFirstStep) {
    const std::vector<uint8_t> before = draw("before"), water = draw("water");
    EXPECT_EQ(brightness(before, sky), 0) << "a triangle on black";
    EXPECT_EQ(brightness(before, near), 0);
    EXPECT_EQ(change(before, water, {108, 50, 118, 60}), 0) << "the triangle stays as it was";
    const auto sea = mean(water, near);
    EXPECT_GT(sea[2], sea[0] + 10) << "water is blue";
    EXPECT_GT(brightness(water, near), 40) << "and not nearly black";
    EXPECT_LT(brightness(water, near), brightness(water, sky)) << "nor as bright as the sky";
}

TEST(Tutorial, GainsWhatEachStepSays) {
    const std::vector<uint8_t> sea = draw("water"), cove = draw("cove"), mirrors = draw("mirrors"),
                               foam = draw("foam"), dive = draw("dive");
    EXPECT_EQ(mean(sea, sky), mean(cove, sky)) << "what is not water stays as it was";
    EXPECT_GT(mean(cove, near)[0], mean(sea, near)[0] + 10) << "sand shines through";
    EXPECT_GT(change(cove, mirrors, lighthouse), 5) << "the lighthouse is mirrored";
    EXPECT_EQ(mean(cove, sky), mean(mirrors, sky));
    EXPECT_GT(change(mirrors, foam, near), 2) << "stronger waves";
    EXPECT_GT(change(foam, dive, sky), 20) << "the surface from below";
}

TEST(Minimal, GainsASeaByItsDiff) {
    const std::vector<uint8_t> rgb =
        draw(fs::path(SEAGLASS_STATES) / "sea/build/triangle", {}, "P6 640 360 255\n");
    ASSERT_EQ(rgb.size(), size_t{3} * 640 * 360);
    const auto meanOfRow = [&](uint32_t y) {
        double sum = 0;
        for (uint32_t x = 0; x < 100; ++x) sum += rgb[3 * (size_t{y} * 640 + x) + 2];
        return sum / 100;
    };
    EXPECT_GT(meanOfRow(350), 30) << "not nearly black";
    EXPECT_GT(meanOfRow(190), meanOfRow(350) + 20) << "mirrors more of the sky the flatter it is seen";
    EXPECT_NE(meanOfRow(350), meanOfRow(340)) << "waves";
}

} // namespace
