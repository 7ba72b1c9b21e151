#include "demos/tools/metrics/compare.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/metrics/painted.h"

namespace {

using demos::Comparison;
using demos::Limits;
using demos::PictureKind;
using tests::grey;
using tests::harbour;
using tests::Painted;

Comparison compared(const Painted& a, const Painted& b, const Limits& limits = {},
                    PictureKind kind = PictureKind::display) {
    return demos::compare(a.view(), b.view(), kind, limits);
}

std::string objections(const Painted& a, const Painted& b, const Limits& limits,
                       PictureKind kind = PictureKind::display) {
    std::string all;
    for (const std::string& objection : demos::objections(compared(a, b, limits, kind), limits)) {
        all += objection + "; ";
    }
    return all;
}

/// Holds everything else back: whatever fails under it fails for its own reason.
const Limits generous = {1e9, 1e9, {{1e9, 1}}};

TEST(Compare, EqualPicturesAreEqualByEveryMeasure) {
    for (const PictureKind kind : {PictureKind::display, PictureKind::linear}) {
        const Comparison found = compared(harbour(), harbour(), {0, 0, {{0, 0}}}, kind);
        EXPECT_EQ(found.flipMean, 0);
        EXPECT_EQ(found.flipMax, 0);
        EXPECT_EQ(found.difference.max, 0);
        EXPECT_EQ(found.psnrDb, HUGE_VAL);
        EXPECT_EQ(objections(harbour(), harbour(), {0, 0, {{0, 0}}}, kind), "");
    }
}

TEST(Compare, SizesMustAgree) {
    EXPECT_NE(objections(grey(20, 10), grey(10, 20), generous).find("size"), std::string::npos);
    EXPECT_NE(objections(grey(20, 10), {}, generous).find("size"), std::string::npos);
}

TEST(Compare, NanInEitherPictureFailsWhateverElse) {
    for (const PictureKind kind : {PictureKind::display, PictureKind::linear}) {
        for (const float broken :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            for (const int channel : {0, 2, 3}) {
                Painted picture = harbour();
                picture.at(5, 5, channel) = broken;
                EXPECT_EQ(objections(harbour(), picture, generous, kind),
                          "NaN or infinity in 1 pixels of the test, the first at 5,5, expected none; ");
                EXPECT_EQ(objections(picture, harbour(), generous, kind),
                          "NaN or infinity in 1 pixels of the reference, the first at 5,5, expected none; ");
                EXPECT_NE(objections(picture, picture, generous, kind), "") << "equal, and broken";
            }
        }
    }
}

TEST(Compare, NanIsSeenOnTheMapAndSpreadsNowhere) {
    Painted picture = harbour();
    picture.at(5, 5, 1) = std::numeric_limits<float>::quiet_NaN();
    const Comparison found = compared(harbour(), picture);
    for (size_t i = 0; i < found.flipMap.size(); ++i) {
        EXPECT_EQ(found.flipMap[i], i == 5 * 160 + 5 ? 1.0f : 0.0f);
    }
    EXPECT_EQ(found.difference.max, 0);
}

TEST(Compare, ASpotIsNotDiluted) {
    Painted spotted = harbour();
    // 20 by 10 pixels, as a logo: a little over one in a hundred.
    for (int y = 70; y < 80; ++y) {
        for (int x = 10; x < 30; ++x) spotted.at(x, y, 0) = 1;
    }
    const Limits limits = {0.05, 0.01, {{0.2, 0.005}}};
    const Comparison found = compared(harbour(), spotted, limits);
    EXPECT_LT(found.flipMean, 0.02);
    EXPECT_GT(found.flipP99, 0.3);
    EXPECT_GT(found.flipMax, 0.3);
    EXPECT_NEAR(found.shares.front(), 0.0125, 1e-9);
    EXPECT_EQ(objections(harbour(), spotted, limits),
              "share of pixels off by more than 0.2 is 0.0125, expected at most 0.005; ");
}

TEST(Compare, P99IsTheLeastThatNinetyNineInAHundredAreWithin) {
    // Shares are of pixels; one broken pixel in a hundred is 1 on the map and beyond the rank.
    Painted one = grey(10, 10), two = one;
    one.at(0, 0, 0) = two.at(0, 0, 0) = two.at(1, 0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compared(grey(10, 10), one).flipP99, 0);
    EXPECT_EQ(compared(grey(10, 10), two).flipP99, 1);
}

TEST(Compare, EachLimitObjectsForItself) {
    Painted tinted = grey(40, 40);
    for (float& value : tinted.rgba) value += 0.02f;
    const auto words = [&](const Limits& limits) { return objections(grey(40, 40), tinted, limits); };
    EXPECT_TRUE(words({0.001, {}, {}}).starts_with("mean FLIP is 0."));
    EXPECT_EQ(words({{}, 0.01, {}}), "mean difference is 0.02, expected at most 0.01; ");
    EXPECT_EQ(words({{}, {}, {{0.01, 0.5}}}),
              "share of pixels off by more than 0.01 is 1, expected at most 0.5; ");
    EXPECT_EQ(words({{}, {}, {{0.03, 0}, {0.01, 1}}}), "");
}

TEST(Compare, PsnrOfLinearPicturesIsOfTheReferencesPeak) {
    const Painted reference = grey(10, 10, 10);
    Painted test = reference;
    for (float& value : test.rgba) value += 1;
    EXPECT_NEAR(compared(reference, test, {}, PictureKind::linear).psnrDb, 20, 1e-6);
}

} // namespace
