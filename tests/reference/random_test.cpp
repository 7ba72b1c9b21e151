// The reference's random numbers: of each call the first 16 fill the square evenly, and calls do not know of
// each other.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "reference/random.h"

namespace {

using demos::reference::Random;

constexpr uint32_t samples = 16, calls = 8, pixels = 64;

/// Of one pixel: by sample, by call.
using Points = std::array<std::array<glm::vec2, calls>, samples>;

Points pointsOf(uint32_t pixel, uint64_t seed) {
    Points points;
    for (uint32_t sample = 0; sample < samples; ++sample) {
        Random random(pixel, sample, seed);
        for (glm::vec2& point : points[sample]) point = random.next2();
    }
    return points;
}

/// How many boxes of `across` by samples / `across` hold one point each.
uint32_t boxesWithOne(const Points& points, size_t call, uint32_t across) {
    std::array<uint32_t, samples> count{};
    for (const auto& sample : points) {
        const auto x = static_cast<uint32_t>(sample[call].x * static_cast<float>(across)),
                   y = static_cast<uint32_t>(sample[call].y * static_cast<float>(samples / across));
        ++count.at(y * across + x);
    }
    return static_cast<uint32_t>(std::ranges::count(count, 1u));
}

TEST(Random, FillsTheSquareEvenlyInEachCall) {
    for (uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const Points points = pointsOf(pixel, 1);
        for (size_t call = 0; call < calls; ++call)
            for (const uint32_t across : {1u, 2u, 4u, 8u, 16u})
                EXPECT_EQ(boxesWithOne(points, call, across), samples)
                    << pixel << ", " << call << ", " << across;
    }
}

/// Of one and the same sample: of calls, pixels and seeds.
TEST(Random, KnowsNothingOfOtherCallsPixelsAndSeeds) {
    double ofCalls = 0, ofPixels = 0, ofSeeds = 0, ofItself = 0;
    const auto together = [](const glm::vec2& a, const glm::vec2& b) {
        return static_cast<double>(glm::dot(a - 0.5f, b - 0.5f));
    };
    for (uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const Points points = pointsOf(pixel, 1), next = pointsOf(pixel + 1, 1), seeded = pointsOf(pixel, 2);
        for (size_t i = 0; i < samples; ++i)
            for (size_t call = 1; call < calls; ++call) {
                const glm::vec2& point = points[i][call];
                ofItself += together(point, point);
                ofCalls += together(point, points[i][call - 1]);
                ofPixels += together(point, next[i][call]);
                ofSeeds += together(point, seeded[i][call]);
            }
    }
    EXPECT_NEAR(ofItself / (pixels * samples * (calls - 1)), 2.0 / 12, 0.001);
    for (const double apart : {ofCalls, ofPixels, ofSeeds}) EXPECT_NEAR(apart / ofItself, 0, 0.03);
}

TEST(Random, IsAFunctionOfPixelSampleAndSeed) {
    EXPECT_EQ(pointsOf(5, 7), pointsOf(5, 7));
    EXPECT_NE(pointsOf(5, 7), pointsOf(6, 7));
    EXPECT_NE(pointsOf(5, 7), pointsOf(5, uint64_t(7) << 32));
}

} // namespace
