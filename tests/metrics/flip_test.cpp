#include "demos/tools/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "demos/tools/metrics/flip_hdr.h"
#include "tests/metrics/painted.h"

namespace {

using demos::flip;
using demos::hdrFlip;
using tests::grey;
using tests::harbour;
using tests::Painted;

double mean(const std::vector<float>& map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

double greatest(const std::vector<float>& map) {
    return static_cast<double>(*std::max_element(map.begin(), map.end()));
}

double meanFlip(const Painted& a, const Painted& b) {
    return mean(flip(a.view(), b.view()));
}

// The pictures of flip_reference.py, and what it says of them. It follows the papers independently, in double
// precision and with dense filters. The pair of pictures that FLIP's authors publish means for (0.159691 and,
// in HDR, 0.283478) comes with their code alone, and is not here.
struct Spot {
    size_t x, y;
    double error;
};

constexpr int width = 64, height = 48;

int byteOf(bool test, int x, int y, int channel) {
    constexpr int disc[] = {230, 90, 30}, light[] = {250, 240, 200}, dark[] = {20, 30, 60};
    if (x >= 36 && y < 20) return (x + (test ? 1 : 0)) / 3 % 2 == 0 ? light[channel] : dark[channel];
    if (!test && (x - 20) * (x - 20) + (y - 14) * (y - 14) < 49) return disc[channel];
    const int saw = (3 * x + 2 * y + 60 * channel) % 256;
    return test && channel == 2 && x < 24 && y >= 32 ? std::min(saw + 12, 255) : saw;
}

Painted encoded(bool test) {
    return tests::painted(width, height, [test](int x, int y, int channel) {
        return static_cast<float>(byteOf(test, x, y, channel)) / 255;
    });
}

Painted linear(bool test) {
    return tests::painted(width, height, [test](int x, int y, int channel) {
        const float value = static_cast<float>(byteOf(test, x, y, channel)) / 255;
        return std::ldexp(value * value, x / 8 - 3);
    });
}

void expectSpots(const std::vector<float>& map, const std::vector<Spot>& spots) {
    for (const Spot& spot : spots) {
        EXPECT_NEAR(static_cast<double>(map[spot.y * width + spot.x]), spot.error, 2e-4)
            << "at " << spot.x << ", " << spot.y;
    }
}

TEST(Flip, IsWhatThePaperComputes) {
    const std::vector<float> map = flip(encoded(false).view(), encoded(true).view());
    EXPECT_NEAR(mean(map), 0.18748409, 5e-7);
    EXPECT_NEAR(greatest(map), 0.963084, 5e-6);
    expectSpots(map, {{0, 0, 0.000000},
                      {20, 14, 0.963084},
                      {27, 14, 0.534364},
                      {45, 10, 0.649215},
                      {36, 0, 0.304243},
                      {12, 40, 0.191639},
                      {24, 32, 0.043258},
                      {63, 47, 0.000000}});
}

TEST(Flip, OfStepsOfAByteIsThatOfValuesBesideThem) {
    const Painted steps = encoded(true);
    Painted beside = steps;
    for (float& value : beside.rgba) value = std::nextafter(value, 0.5f);
    EXPECT_LT(greatest(flip(steps.view(), beside.view())), 2e-3);
    const float nan = std::nanf("");
    const Painted none = tests::painted(width, height, [nan](int, int, int) { return nan; });
    EXPECT_EQ(greatest(flip(none.view(), grey(width, height, 0).view())), 0) << "NaN is black";
}

TEST(HdrFlip, IsWhatThePaperComputes) {
    const demos::HdrFlip hdr = hdrFlip(linear(false).view(), linear(true).view());
    EXPECT_NEAR(hdr.exposures.startEv, -2.736031, 2e-6);
    EXPECT_NEAR(hdr.exposures.stopEv, 2.489162, 2e-6);
    EXPECT_EQ(hdr.exposures.count, 6);
    EXPECT_NEAR(mean(hdr.map), 0.18687571, 5e-7);
    EXPECT_NEAR(greatest(hdr.map), 0.970206, 5e-6);
    expectSpots(hdr.map, {{0, 0, 0.000000},
                          {20, 14, 0.967976},
                          {27, 14, 0.613886},
                          {45, 10, 0.537163},
                          {36, 0, 0.321413},
                          {12, 40, 0.104828},
                          {24, 32, 0.021916},
                          {63, 47, 0.000000}});
}

TEST(Flip, OfBlackAndWhiteIsWhatAHandComputes) {
    // |dL*| = 100 against the 203.3 between green and blue, by the exponent 0.7 and the knee.
    const std::vector<float> map = flip(grey(20, 20, 0).view(), grey(20, 20, 1).view());
    for (const float error : map) ASSERT_NEAR(static_cast<double>(error), 0.967380, 1e-6);
}

TEST(Flip, OfAPictureAndItselfIsNothing) {
    const Painted picture = harbour();
    EXPECT_EQ(greatest(flip(picture.view(), picture.view())), 0);
    EXPECT_EQ(greatest(hdrFlip(picture.view(), picture.view()).map), 0);
}

TEST(Flip, IsSymmetric) {
    EXPECT_EQ(flip(encoded(false).view(), encoded(true).view()),
              flip(encoded(true).view(), encoded(false).view()));
}

TEST(HdrFlip, TakesItsExposuresFromTheReference) {
    const Painted dim = linear(false);
    Painted bright = dim;
    for (float& value : bright.rgba) value *= 16;
    const demos::HdrFlip forth = hdrFlip(dim.view(), bright.view()),
                         back = hdrFlip(bright.view(), dim.view());
    EXPECT_NEAR(forth.exposures.startEv, back.exposures.startEv + 4, 1e-5);
}

TEST(HdrFlip, IsTheSameUnderAnyUnitOfLight) {
    const auto scaled = [](Painted picture) {
        for (float& value : picture.rgba) value = std::ldexp(value, 40);
        return picture;
    };
    const std::vector<float> one = hdrFlip(linear(false).view(), linear(true).view()).map;
    const std::vector<float> other = hdrFlip(scaled(linear(false)).view(), scaled(linear(true)).view()).map;
    for (size_t i = 0; i < one.size(); ++i) ASSERT_NEAR(one[i], other[i], 1e-4f);
}

TEST(HdrFlip, SeesWhatOnlyOneExposureShows) {
    // Two lights far beyond white, one twice the other: tone-mapped once, both are white.
    Painted reference = grey(64, 64, 0.1f), test = reference;
    for (int i = 24; i < 40; ++i) {
        for (int j = 24; j < 40; ++j) {
            for (int channel = 0; channel < 3; ++channel) {
                reference.at(i, j, channel) = 1000;
                test.at(i, j, channel) = 2000;
            }
        }
    }
    EXPECT_LT(greatest(flip(reference.view(), test.view())), 1e-6);
    EXPECT_GT(greatest(hdrFlip(reference.view(), test.view()).map), 0.1);
}

TEST(HdrFlip, StandsPicturesOfBlackAndOfAnyRange) {
    const Painted black = grey(32, 32, 0), dim = grey(32, 32, 1e-6f);
    EXPECT_EQ(greatest(hdrFlip(black.view(), black.view()).map), 0);
    EXPECT_GT(greatest(hdrFlip(black.view(), dim.view()).map), 0.5) << "the test's exposures count";
    EXPECT_GT(greatest(hdrFlip(dim.view(), black.view()).map), 0.5);

    const Painted mostlyBlack = tests::painted(32, 32, [](int x, int, int) { return x < 24 ? 0.0f : 1.0f; });
    EXPECT_TRUE(std::isfinite(demos::exposureRange(mostlyBlack.view()).stopEv));

    const Painted vast = tests::painted(32, 32, [](int x, int, int) { return x < 24 ? 1e-30f : 1e38f; });
    const demos::HdrFlip hdr = hdrFlip(vast.view(), dim.view());
    EXPECT_EQ(hdr.exposures.count, 33);
    for (const float error : hdr.map) EXPECT_TRUE(error >= 0 && error <= 1) << error;

    const Painted negative = grey(32, 32, -1);
    EXPECT_EQ(greatest(hdrFlip(black.view(), negative.view()).map), 0) << "less light than none is none";
}

TEST(HdrFlip, MiddleGreyIsTheMediansExposure) {
    const demos::ExposureRange range = demos::exposureRange(grey(8, 8, 0.09f).view());
    EXPECT_NEAR(demos::middleGreyEv(range), 1, 1e-6);
}

Painted blurred(const Painted& picture, int radius) {
    return tests::painted(
        static_cast<int>(picture.width), static_cast<int>(picture.height), [&](int x, int y, int channel) {
            float sum = 0;
            for (int j = -radius; j <= radius; ++j) {
                for (int i = -radius; i <= radius; ++i) {
                    const int u = std::clamp(x + i, 0, static_cast<int>(picture.width) - 1);
                    const int v = std::clamp(y + j, 0, static_cast<int>(picture.height) - 1);
                    sum += picture.at(u, v, channel);
                }
            }
            return sum / static_cast<float>((2 * radius + 1) * (2 * radius + 1));
        });
}

TEST(Flip, GrowsWithBlur) {
    const Painted sharp = harbour();
    double before = 0;
    for (const int radius : {1, 2, 4, 8}) {
        const double now = meanFlip(sharp, blurred(sharp, radius));
        EXPECT_GT(now, before) << "radius " << radius;
        before = now;
    }
}

TEST(Flip, GrowsWithNoise) {
    const Painted clean = harbour();
    double before = 0;
    for (const float amount : {0.01f, 0.03f, 0.1f, 0.3f}) {
        Painted noisy = clean;
        uint32_t state = 1;
        for (float& value : noisy.rgba) {
            state = state * 1664525u + 1013904223u;
            value += amount * (static_cast<float>(state >> 8) / 16777216.0f - 0.5f);
        }
        const double now = meanFlip(clean, noisy);
        EXPECT_GT(now, before) << "amount " << amount;
        before = now;
    }
}

TEST(Flip, FallsWithDistance) {
    const Painted sharp = harbour(), soft = blurred(sharp, 2);
    const double near = mean(flip(sharp.view(), soft.view(), 30));
    const double far = mean(flip(sharp.view(), soft.view(), 120));
    EXPECT_GT(near, 1.2 * far);
}

TEST(Flip, OfAShiftByAPixelIsSmallAndOfAMissingHullLarge) {
    const Painted whole = harbour();
    const Painted shifted = tests::painted(
        160, 100, [&](int x, int y, int channel) { return whole.at(std::max(x - 1, 0), y, channel); });
    Painted missing = whole;
    for (int y = 25; y < 60; ++y) {
        for (int x = 70; x < 90; ++x) {
            for (int channel = 0; channel < 3; ++channel)
                missing.at(x, y, channel) = whole.rgba[size_t(channel)];
        }
    }
    const std::vector<float> shift = flip(whole.view(), shifted.view());
    const std::vector<float> gone = flip(whole.view(), missing.view());
    EXPECT_LT(mean(shift), 0.06);
    EXPECT_GT(greatest(gone), 0.8);
    // The hull is 4.4 % of the picture; of the shift, its two edges and the waves show.
    const double insideGone = static_cast<double>(gone[42 * 160 + 80]);
    const double insideShift = static_cast<double>(shift[42 * 160 + 80]);
    EXPECT_GT(insideGone, 0.8);
    EXPECT_LT(insideShift, 0.01);
}

Painted mirrored(const Painted& picture) {
    const int width = static_cast<int>(picture.width);
    return tests::painted(width, static_cast<int>(picture.height),
                          [&](int x, int y, int channel) { return picture.at(width - 1 - x, y, channel); });
}

TEST(Flip, IsTheSameWhereverItsStripsOfColumnsAre) {
    // Rows and columns that are the same in both are left out; these differ in places alone.
    constexpr int wide = 530, high = 70;
    const auto wave = [](int x, int y, int channel) {
        return 0.5f + 0.4f * std::sin(0.3f * static_cast<float>(x) + 0.2f * static_cast<float>(y * channel));
    };
    const Painted reference = tests::painted(wide, high, wave);
    Painted test = reference;
    for (const int x : {0, 100, 250, 262, 400, 515, 529})
        for (const int y : {0, 31, 69}) test.at(x, y, 0) = 0;
    const std::vector<float> map = flip(reference.view(), test.view());
    const std::vector<float> other = flip(mirrored(reference).view(), mirrored(test).view());
    for (size_t y = 0; y < high; ++y)
        for (size_t x = 0; x < wide; ++x)
            ASSERT_NEAR(map[y * wide + x], other[y * wide + wide - 1 - x], 1e-5f) << x << ", " << y;
    EXPECT_GT(map[31 * wide + 262], 0.1f);
    EXPECT_EQ(map[50 * wide + 262], 0);
}

TEST(Flip, StandsPicturesSmallerThanItsFilters) {
    EXPECT_NEAR(static_cast<double>(flip(grey(1, 1, 0).view(), grey(1, 1, 1).view()).front()), 0.967380,
                1e-6);
    EXPECT_TRUE(flip({}, {}).empty());
}

} // namespace
