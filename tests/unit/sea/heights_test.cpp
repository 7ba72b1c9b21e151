#include "seaglass/sea.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

namespace {

using namespace seaglass;
using tests::directSum;
using tests::DirectSum;
using tests::makeSea;
using tests::Maps;
using tests::Waves;

HeightSample heightAt(const Sea& sea, double time, double u, double v) {
    const double point[] = {u, v};
    HeightSample sample;
    sampleHeights(sea, time, point, 1, &sample);
    return sample;
}

bool same(const HeightSample& a, const HeightSample& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

std::vector<double> scattered(size_t count) {
    std::vector<double> points(2 * count);
    for (size_t i = 0; i < points.size(); ++i)
        points[i] = std::fmod(71.37 * static_cast<double>(i * i), 900) - 300;
    return points;
}

TEST(Heights, AgreeWithTheMapsWhereTheTexelsGo) {
    SeaDesc desc = tests::oneCascade();
    desc.windDirection = 1.1f;
    const auto sea = makeSea(desc);
    constexpr double time = 25, spacing = 512.0 / 64;
    const Maps maps = Waves(*sea).at(0, time);
    for (size_t texel = 0; texel < maps.texels(); texel += 97) {
        if (maps.jacobian(texel) < 0.2) continue;
        const float* d = &maps.displacement[4 * texel];
        const float* s = &maps.derivatives[4 * texel];
        const HeightSample found =
            heightAt(*sea, time, static_cast<double>(texel % 64) * spacing + static_cast<double>(d[0]),
                     static_cast<double>(texel / 64) * spacing + static_cast<double>(d[2]));
        EXPECT_EQ(found.folded, 0u) << texel;
        EXPECT_NEAR(found.height, maps.height(texel), 1e-4) << texel;
        // Along both tangents of the displaced surface the normal has no part.
        const float tangentU = found.normal[0] * (1 + s[2]) + found.normal[1] * s[0] + found.normal[2] * d[3];
        const float tangentV = found.normal[0] * d[3] + found.normal[1] * s[1] + found.normal[2] * (1 + s[3]);
        EXPECT_NEAR(tangentU, 0, 1e-4) << texel;
        EXPECT_NEAR(tangentV, 0, 1e-4) << texel;
        EXPECT_GT(found.normal[1], 0) << texel;
        EXPECT_NEAR(std::hypot(found.normal[0], found.normal[1], found.normal[2]), 1, 1e-6) << texel;
    }
}

// The texels (0, 0) of all cascades coincide.
TEST(Heights, AddAllCascades) {
    SeaDesc desc;
    desc.choppiness = 0.5f;
    const auto sea = makeSea(desc);
    Waves waves(*sea);
    double height = 0, shift[2] = {}, velocity[3] = {};
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
        const Maps maps = waves.at(c, 60);
        height += maps.height(0);
        shift[0] += static_cast<double>(maps.displacement[0]);
        shift[1] += static_cast<double>(maps.displacement[2]);
        const DirectSum sum = directSum(*sea, c, 60, 0, 0);
        velocity[0] += sum.vx;
        velocity[1] += sum.vy;
        velocity[2] += sum.vz;
    }
    const HeightSample found = heightAt(*sea, 60, shift[0], shift[1]);
    EXPECT_NEAR(found.height, height, 1e-4);
    for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(found.velocity[a], velocity[a], 1e-4) << a;
}

TEST(Heights, VelocityIsThatOfTheWater) {
    const auto sea = makeSea(tests::oneCascade());
    Waves waves(*sea);
    constexpr double time = 25, step = 0.05, spacing = 512.0 / 64;
    const Maps before = waves.at(0, time - step), now = waves.at(0, time), after = waves.at(0, time + step);
    for (size_t texel = 0; texel < now.texels(); texel += 211) {
        if (now.jacobian(texel) < 0.2) continue;
        const float* d = &now.displacement[4 * texel];
        const HeightSample found =
            heightAt(*sea, time, static_cast<double>(texel % 64) * spacing + static_cast<double>(d[0]),
                     static_cast<double>(texel / 64) * spacing + static_cast<double>(d[2]));
        for (size_t a = 0; a < 3; ++a) {
            const double moved = after.displacement[4 * texel + a] - before.displacement[4 * texel + a];
            EXPECT_NEAR(found.velocity[a], moved / (2 * step), 0.01) << texel << ", " << a;
        }
    }
}

TEST(Heights, WaterAtACrestMovesDownwind) {
    SeaDesc desc;
    desc.windDirection = 2;
    const auto sea = makeSea(desc);
    const auto points = scattered(100);
    std::vector<HeightSample> samples(100);
    sampleHeights(*sea, 5, points.data(), samples.size(), samples.data());
    double along = 0;
    for (const HeightSample& s : samples)
        along += static_cast<double>(s.height) * (static_cast<double>(s.velocity[0]) * std::cos(2.0) +
                                                  static_cast<double>(s.velocity[2]) * std::sin(2.0));
    EXPECT_GT(along, 0);
}

TEST(Heights, StaysExactForYearsAndFarFromTheOrigin) {
    const auto sea = makeSea(tests::oneCascade());
    const HeightSample here = heightAt(*sea, 12.5, 100.25, -31.5);
    EXPECT_TRUE(same(here, heightAt(*sea, 12.5 + 4096 * 8000.0, 100.25, -31.5)));
    EXPECT_TRUE(same(here, heightAt(*sea, 12.5 - 4096, 100.25, -31.5)));
    EXPECT_NEAR(here.height, heightAt(*sea, 12.5, 100.25 + 512 * 1e6, -31.5 - 512 * 1e6).height, 1e-6);
    const double tiles = 512 * 0x1p40;
    EXPECT_TRUE(same(heightAt(*sea, 12.5, 100, -31), heightAt(*sea, 12.5, 100 + tiles, -31 - tiles)));
    EXPECT_NE(here.height, heightAt(*sea, 12.5, 100.25 + 256, -31.5).height);
}

TEST(Heights, SameBitsAloneAndTogether) {
    const auto sea = makeSea(tests::oneCascade());
    const auto points = scattered(20);
    std::vector<HeightSample> together(20);
    sampleHeights(*sea, 8, points.data(), 20, together.data());
    for (size_t i = 20; i-- > 0;)
        EXPECT_TRUE(same(together[i], heightAt(*sea, 8, points[2 * i], points[2 * i + 1]))) << i;
    sampleHeights(*sea, 8, nullptr, 0, nullptr);
}

TEST(Heights, SameBitsFromManyThreads) {
    SeaDesc desc;
    desc.samples = 64;
    const auto sea = makeSea(desc);
    const auto points = scattered(50);
    std::vector<HeightSample> expected(50);
    sampleHeights(*sea, 8, points.data(), 50, expected.data());
    std::vector<std::vector<HeightSample>> found(4, std::vector<HeightSample>(50));
    {
        std::vector<std::jthread> threads;
        for (auto& samples : found)
            threads.emplace_back([&] { sampleHeights(*sea, 8, points.data(), 50, samples.data()); });
    }
    for (const auto& samples : found)
        for (size_t i = 0; i < 50; ++i) EXPECT_TRUE(same(samples[i], expected[i])) << i;
}

TEST(Heights, SettleInASteepSea) {
    SeaDesc desc;
    desc.windSpeed = 15;
    const auto sea = makeSea(desc);
    const auto points = scattered(300);
    std::vector<HeightSample> samples(300);
    sampleHeights(*sea, 5, points.data(), samples.size(), samples.data());
    size_t folded = 0;
    for (const HeightSample& s : samples) folded += s.folded;
    EXPECT_LE(folded, 6u);
}

TEST(Heights, SayWhereTheSurfaceFolds) {
    SeaDesc desc;
    desc.samples = 64;
    desc.choppiness = 10;
    const auto sea = makeSea(desc);
    // Of some hundred the surface overturns at one or two.
    const auto points = scattered(2000);
    std::vector<HeightSample> samples(2000);
    sampleHeights(*sea, 5, points.data(), samples.size(), samples.data());
    size_t folded = 0;
    for (const HeightSample& s : samples) {
        folded += s.folded;
        EXPECT_TRUE(std::isfinite(s.height));
        EXPECT_GE(s.normal[1], 0);
    }
    std::printf("%zu of 2000 points are folded\n", folded);
    EXPECT_GT(folded, 200u);
    // Where the step towards a point is not held, it flies off to others that fold.
    EXPECT_LT(folded, 775u);

    desc.choppiness = 0;
    sampleHeights(*makeSea(desc), 5, points.data(), samples.size(), samples.data());
    for (const HeightSample& s : samples) EXPECT_EQ(s.folded, 0u);
}

TEST(Heights, WithoutChoppinessAreThePlainSum) {
    SeaDesc desc = tests::oneCascade();
    desc.choppiness = 0;
    const auto sea = makeSea(desc);
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {123.4, -56.7}, {-1000.1, 77.7}}) {
        const DirectSum sum = directSum(*sea, 0, 3, u, v);
        const HeightSample found = heightAt(*sea, 3, u, v);
        EXPECT_NEAR(found.height, sum.h, 1e-6);
        EXPECT_NEAR(found.normal[0] / found.normal[1], -sum.hu, 1e-6);
        EXPECT_NEAR(found.normal[2] / found.normal[1], -sum.hv, 1e-6);
        EXPECT_EQ(found.velocity[0], 0);
        EXPECT_NEAR(found.velocity[1], sum.vy, 1e-6);
    }
}

TEST(Heights, AreCalmAndMarkedWhereThereIsNoPoint) {
    const auto sea = makeSea(tests::oneCascade());
    const HeightSample found = heightAt(*sea, 0, std::numeric_limits<double>::quiet_NaN(), 0);
    EXPECT_EQ(found.height, 0);
    EXPECT_EQ(found.normal[1], 1);
    EXPECT_EQ(found.folded, 1u);
}

} // namespace
