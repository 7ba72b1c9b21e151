#include "tests/visual/limits.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/metrics/painted.h"

namespace {

using tests::grey;
using tests::Painted;

std::string judge(const Painted& expected, const Painted& actual) {
    const demos::Limits limits = tests::goldenLimits();
    const auto kind = demos::PictureKind::display;
    std::string all;
    for (const std::string& objection :
         demos::objections(demos::compare(expected.view(), actual.view(), kind, limits), limits)) {
        all += objection + "; ";
    }
    return all;
}

Painted golden() {
    return grey(200, 100);
}

/// Adds to one channel of the first `count` pixels.
Painted shifted(size_t count, float by) {
    Painted picture = golden();
    for (size_t i = 0; i < count; ++i) picture.rgba[4 * i + 1] += by;
    return picture;
}

constexpr const char* littleOff = "off by more than 0.01176";
constexpr const char* lotOff = "off by more than 0.09412";

bool says(const std::string& words, const char* what) {
    return words.find(what) != std::string::npos;
}

TEST(GoldenLimits, EqualPicturesPass) {
    EXPECT_EQ(judge(golden(), golden()), "");
}

TEST(GoldenLimits, AFewPixelsMayDiffer) {
    EXPECT_EQ(judge(golden(), shifted(5, 0.4f)), "");
}

TEST(GoldenLimits, ASpotIsCaughtThatAMeanForgives) {
    const std::string words = judge(golden(), shifted(20, 0.4f));
    EXPECT_TRUE(says(words, lotOff)) << words;
    EXPECT_FALSE(says(words, "mean")) << words;
}

TEST(GoldenLimits, ManySmallDifferencesAreCaught) {
    const std::string words = judge(golden(), shifted(300, 5.0f / 255));
    EXPECT_TRUE(says(words, littleOff)) << words;
    EXPECT_FALSE(says(words, lotOff)) << words;
}

TEST(GoldenLimits, AFaintTintIsCaughtByTheMean) {
    const std::string words = judge(golden(), shifted(200 * 100, 2.0f / 255));
    EXPECT_TRUE(says(words, "mean difference")) << words;
    EXPECT_FALSE(says(words, "share")) << words;
}

TEST(GoldenLimits, AFaintTintIsCaughtByFlipWhereItsMeanIsNot) {
    // Yellower all over, by less than the mean allows.
    Painted tinted = golden();
    for (size_t i = 0; i < tinted.rgba.size(); i += 4) {
        tinted.rgba[i] += 0.7f / 255;
        tinted.rgba[i + 2] -= 0.7f / 255;
    }
    const std::string words = judge(golden(), tinted);
    EXPECT_TRUE(says(words, "mean FLIP")) << words;
    EXPECT_FALSE(says(words, "mean difference")) << words;
    EXPECT_FALSE(says(words, "share")) << words;
}

TEST(GoldenLimits, SizesMustAgree) {
    EXPECT_TRUE(says(judge(golden(), grey(100, 200)), "size"));
    EXPECT_TRUE(says(judge(golden(), {}), "size"));
}

TEST(GoldenLimits, NanIsALargeDifference) {
    const std::string words = judge(golden(), shifted(100, std::numeric_limits<float>::quiet_NaN()));
    EXPECT_TRUE(says(words, "NaN")) << words;
    EXPECT_TRUE(says(words, lotOff)) << words;
}

} // namespace
