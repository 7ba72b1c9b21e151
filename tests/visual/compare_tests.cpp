#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/visual/compare.h"

namespace {

using demos::Picture;
using tests::Limits;

Picture grey(uint32_t width = 200, uint32_t height = 100) {
    return {width, height, std::vector<float>(size_t{4} * width * height, 0.5f)};
}

std::string judge(const Picture& expected, const Picture& actual) {
    return tests::objections(tests::compare(expected, actual, Limits{}), Limits{});
}

/// Adds to one channel of the first `count` pixels.
Picture shifted(size_t count, float by) {
    Picture picture = grey();
    for (size_t i = 0; i < count; ++i) picture.rgba[4 * i + 1] += by;
    return picture;
}

TEST(Compare, EqualPicturesPass) {
    EXPECT_EQ(judge(grey(), grey()), "");
}

TEST(Compare, AFewPixelsMayDiffer) {
    EXPECT_EQ(judge(grey(), shifted(5, 0.4f)), "");
}

TEST(Compare, ASpotIsCaughtThatAMeanForgives) {
    const std::string words = judge(grey(), shifted(20, 0.4f));
    EXPECT_NE(words.find("off by a lot"), std::string::npos) << words;
    EXPECT_EQ(words.find("mean"), std::string::npos) << words;
}

TEST(Compare, ManySmallDifferencesAreCaught) {
    const std::string words = judge(grey(), shifted(300, 5.0f / 255));
    EXPECT_NE(words.find("off by a little"), std::string::npos) << words;
    EXPECT_EQ(words.find("a lot"), std::string::npos) << words;
}

TEST(Compare, AFaintTintIsCaughtByTheMean) {
    const std::string words = judge(grey(), shifted(200 * 100, 2.0f / 255));
    EXPECT_NE(words.find("mean"), std::string::npos) << words;
    EXPECT_EQ(words.find("share"), std::string::npos) << words;
}

TEST(Compare, SizesMustAgree) {
    EXPECT_NE(judge(grey(200, 100), grey(100, 200)).find("size"), std::string::npos);
    EXPECT_NE(judge(grey(), Picture{}).find("size"), std::string::npos);
}

TEST(Compare, NanIsALargeDifference) {
    const std::string words = judge(grey(), shifted(100, std::numeric_limits<float>::quiet_NaN()));
    EXPECT_NE(words.find("off by a lot"), std::string::npos) << words;
}

TEST(CountNotFinite, CountsPixelsNotChannels) {
    Picture picture = grey();
    EXPECT_EQ(tests::countNotFinite(picture), 0u);
    picture.rgba[0] = picture.rgba[1] = std::numeric_limits<float>::quiet_NaN();
    picture.rgba[4 * 7 + 3] = -std::numeric_limits<float>::infinity();
    EXPECT_EQ(tests::countNotFinite(picture), 2u);
}

TEST(DifferencePicture, IsMidGreyWhereEqual) {
    const std::vector<uint8_t> rgb = tests::differencePicture(grey(), shifted(1, 0.05f));
    ASSERT_EQ(rgb.size(), size_t{3} * 200 * 100);
    EXPECT_EQ(rgb[0], 128);
    EXPECT_EQ(rgb[1], 255);
    EXPECT_EQ(rgb[3], 128);
}

} // namespace
