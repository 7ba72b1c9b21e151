#include "demos/tools/metrics/outlier.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "demos/tools/metrics/compare.h"
#include "demos/tools/metrics/tolerant.h"
#include "tests/metrics/painted.h"

namespace {

using demos::Limits;
using demos::PictureKind;
using tests::harbour;
using tests::Painted;

/// By the limits of `--tolerant`.
std::string judged(const Painted& reference, const Painted& test, PictureKind kind = PictureKind::linear) {
    const Limits limits = demos::tolerantLimits(kind);
    const demos::Comparison found = demos::compare(reference.view(), test.view(), kind, limits);
    std::string all;
    for (const std::string& objection : demos::objections(found, limits)) all += objection + "; ";
    EXPECT_EQ(demos::badness(found, limits) > 1, !all.empty());
    return all;
}

/// With bright things, beside which FLIP sees nothing of what is brighter yet.
Painted sunlit() {
    Painted picture = harbour();
    for (int y = 20; y < 50; ++y)
        for (int x = 60; x < 100; ++x) std::fill_n(&picture.at(x, y, 0), 3, 40.0f);
    return picture;
}

TEST(Outliers, AreFoundBesideWhatIsBright) {
    Painted picture = sunlit();
    std::fill_n(&picture.at(80, 35, 0), 3, 2000.0f);
    const char* const said =
        "1 pixels over twice as bright as all around them, or as far below 0, the first at 80,35, expected "
        "at most 0; ";
    EXPECT_EQ(judged(sunlit(), picture), said);
    EXPECT_NE(judged(picture, sunlit()).find(said), std::string::npos) << "one that is missing";
}

TEST(Outliers, AreBelowZeroAsWell) {
    Painted picture = harbour();
    picture.at(120, 80, 2) = -5;
    EXPECT_NE(judged(harbour(), picture).find("the first at 120,80"), std::string::npos);
}

TEST(Outliers, AreNoEdgesThatMove) {
    Painted picture = sunlit();
    for (int y = 20; y < 50; ++y) std::fill_n(&picture.at(100, y, 0), 3, 40.0f);
    EXPECT_EQ(demos::findOutliers(sunlit().view(), picture.view()).pixels, 0u);
}

// Bright pixels that move by one to any side, over an even ground.
TEST(Outliers, AreNoPointsThatMove) {
    const auto withPoint = [](int x, int y) {
        Painted picture = harbour();
        std::fill_n(&picture.at(x, y, 0), 3, 500.0f);
        return picture;
    };
    const Painted before = withPoint(40, 30);
    for (int down = -1; down <= 1; ++down)
        for (int right = -1; right <= 1; ++right)
            EXPECT_EQ(demos::findOutliers(before.view(), withPoint(40 + right, 30 + down).view()).pixels, 0u)
                << right << ' ' << down;
    EXPECT_EQ(demos::findOutliers(before.view(), withPoint(42, 30).view()).pixels, 2u);
}

// What is no brighter than the picture at large is nothing that eyes fall on.
TEST(Outliers, AreNotInTheDark) {
    Painted dark = harbour();
    for (int y = 20; y < 30; ++y)
        for (int x = 60; x < 70; ++x) std::fill_n(&dark.at(x, y, 0), 3, 1e-4f);
    Painted test = dark;
    std::fill_n(&test.at(65, 25, 0), 3, 1e-3f);
    EXPECT_EQ(demos::findOutliers(dark.view(), test.view()).pixels, 0u);
}

TEST(Alpha, ThatIsLostIsNamed) {
    Painted clear = harbour();
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 12; ++x) clear.at(x, y, 3) = 0.5f;
    for (const PictureKind kind : {PictureKind::display, PictureKind::linear}) {
        const std::string said = judged(clear, harbour(), kind);
        EXPECT_NE(said.find("share of pixels whose alpha is off by more than 0.15 is 0.0"), std::string::npos)
            << said;
    }
}

TEST(Alpha, OfOnePixelFailsByHowMuchItIsOff) {
    Painted one = harbour();
    one.at(3, 3, 3) = 0.25f;
    EXPECT_NE(judged(harbour(), one, PictureKind::display).find("off by more than 0.35 from all around"),
              std::string::npos);
    one.at(3, 3, 3) = 0.75f;
    EXPECT_EQ(judged(harbour(), one, PictureKind::display), "");
    const Limits none = {{}, {}, {{0, 0}}};
    const demos::Comparison found = demos::compare(harbour().view(), one.view(), PictureKind::display, none);
    EXPECT_EQ(demos::objections(found, none).size(), 1u) << "any difference fails without limits";
}

} // namespace
