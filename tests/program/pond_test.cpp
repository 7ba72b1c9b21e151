// demos/minimal: the example that people start from draws what it says, and Vulkan has nothing against it.
#include <gtest/gtest.h>

#include <array>

#include "tests/program/run.h"

namespace {

constexpr size_t width = 640, height = 360;

struct Pixel {
    int red, green, blue;
};

Pixel pixelAt(const std::string& ppm, size_t x, size_t y) {
    const size_t at = ppm.size() - 3 * (width * height - (y * width + x));
    const auto channel = [&](size_t c) { return static_cast<int>(static_cast<unsigned char>(ppm[at + c])); };
    return {channel(0), channel(1), channel(2)};
}

/// Share of the pixels in the box that are more red than blue, as the sail is and neither sky nor water are.
double warm(const std::string& ppm, std::array<size_t, 2> low, std::array<size_t, 2> high) {
    size_t found = 0;
    for (size_t y = low[1]; y < high[1]; ++y)
        for (size_t x = low[0]; x < high[0]; ++x) {
            const Pixel p = pixelAt(ppm, x, y);
            found += p.red > p.blue;
        }
    return static_cast<double>(found) / static_cast<double>((high[0] - low[0]) * (high[1] - low[1]));
}

tests::Outcome pond(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
    return tests::run(SEAGLASS_POND,
                      {arguments,
                       {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                        {"VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}},
                       folder});
}

TEST(Pond, MirrorsTheTriangle) {
    const tests::TemporaryFolder folder;
    const tests::Outcome outcome = pond({"pond.ppm"}, folder.path());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "validation";
    EXPECT_EQ(outcome.err, "");
    const std::string ppm = tests::readAll(folder.path() / "pond.ppm");
    ASSERT_EQ(ppm.size(), std::string("P6 640 360 255\n").size() + 3 * width * height);
    EXPECT_GT(warm(ppm, {320, 130}, {355, 250}), 0.99) << "the sail";
    EXPECT_GT(warm(ppm, {300, 290}, {360, 340}), 0.9) << "its mirror image";
    EXPECT_LT(warm(ppm, {20, 190}, {220, 350}), 0.01) << "water beside it";
    EXPECT_LT(warm(ppm, {20, 10}, {220, 170}), 0.01) << "sky";
    const Pixel far = pixelAt(ppm, 100, 185), near = pixelAt(ppm, 100, 350);
    EXPECT_GT(far.blue, near.blue + 20) << "water mirrors more of the sky the flatter it is seen";
}

TEST(Pond, SaysHowItIsCalled) {
    const tests::TemporaryFolder folder;
    const tests::Outcome outcome = pond({}, folder.path());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "usage: pond OUT.ppm\n");
}

} // namespace
