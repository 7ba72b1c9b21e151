#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "demos/tools/metrics/difference.h"
#include "demos/tools/metrics/finite.h"
#include "demos/tools/metrics/magma.h"
#include "demos/tools/metrics/psnr.h"
#include "tests/metrics/painted.h"

namespace {

using tests::grey;
using tests::Painted;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

TEST(CountNotFinite, CountsPixelsNotChannels) {
    Painted picture = grey(20, 10);
    EXPECT_EQ(demos::countNotFinite(picture.view()), 0u);
    picture.at(0, 0, 0) = picture.at(0, 0, 1) = nan;
    picture.at(7, 0, 3) = -inf;
    EXPECT_EQ(demos::countNotFinite(picture.view()), 2u);
}

TEST(CountNotFinite, LetsTheSkyBeInfinitelyFar) {
    Painted depth = grey(20, 10);
    depth.at(3, 3, 0) = inf;
    EXPECT_EQ(demos::countNotFinite(depth.view(), demos::Infinity::far), 0u);
    depth.at(4, 3, 0) = -inf;
    depth.at(5, 3, 0) = nan;
    EXPECT_EQ(demos::countNotFinite(depth.view(), demos::Infinity::far), 2u);
}

TEST(Difference, IsOfColorOverAllChannels) {
    const Painted a = grey(10, 10);
    Painted b = a;
    b.at(3, 4, 1) += 0.25f;
    b.at(9, 9, 3) = 0;
    const demos::Difference found = demos::difference(a.view(), b.view());
    EXPECT_DOUBLE_EQ(found.max, 0.25);
    EXPECT_DOUBLE_EQ(found.mean, 0.25 / 300);
    EXPECT_DOUBLE_EQ(found.meanSquare, 0.0625 / 300);
}

TEST(ShareOver, IsOfPixelsStrictlyOver) {
    const Painted a = grey(10, 10);
    Painted b = a;
    b.at(3, 4, 0) += 0.25f;
    b.at(3, 4, 2) -= 0.25f;
    EXPECT_DOUBLE_EQ(demos::shareOver(a.view(), b.view(), 0.24), 0.01);
    EXPECT_DOUBLE_EQ(demos::shareOver(a.view(), b.view(), 0.25), 0);
}

TEST(ShareOver, CountsWhatIsNotFiniteAtAnyLimit) {
    const Painted a = grey(10, 10);
    Painted b = a, same = a;
    b.at(1, 1, 0) = nan;
    b.at(2, 1, 1) = inf;
    same.at(2, 1, 1) = inf;
    EXPECT_DOUBLE_EQ(demos::shareOver(a.view(), b.view(), 1e9), 0.02);
    EXPECT_DOUBLE_EQ(demos::shareOver(b.view(), a.view(), 1e9), 0.02);
    EXPECT_DOUBLE_EQ(demos::shareOver(same.view(), b.view(), 1e9), 0.02);
    EXPECT_EQ(demos::difference(a.view(), b.view()).max, 0);
}

// An edge that moves shows what is beside it; a firefly, or one that is lost, is like nothing around.
TEST(ShareUnlikeAround, LetsEdgesMoveAndNothingAppear) {
    const auto edge = [](int at) {
        return tests::painted(10, 10, [at](int x, int, int) { return x < at ? 0.0f : 1.0f; });
    };
    const auto share = [](const Painted& a, const Painted& b) {
        return demos::shareUnlikeAround(a.view(), b.view(), 0.5);
    };
    EXPECT_DOUBLE_EQ(demos::shareOver(edge(5).view(), edge(6).view(), 0.5), 0.1);
    EXPECT_DOUBLE_EQ(share(edge(5), edge(6)), 0);
    EXPECT_DOUBLE_EQ(share(edge(5), edge(7)), 0.2) << "by two pixels";
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(2, 9), std::pair(3, 4)}) {
        Painted lit = edge(7);
        lit.at(x, y, 1) = 0.6f;
        EXPECT_DOUBLE_EQ(share(edge(7), lit), 0.01) << x << ", " << y;
        EXPECT_DOUBLE_EQ(share(lit, edge(7)), 0.01) << x << ", " << y;
    }
    Painted broken = edge(5);
    broken.at(1, 1, 0) = nan;
    EXPECT_DOUBLE_EQ(share(edge(5), broken), 0.01);
}

TEST(Psnr, IsInDecibels) {
    EXPECT_NEAR(demos::psnrDb(1e-4, 1), 40, 1e-9);
    EXPECT_NEAR(demos::psnrDb(1, 10), 20, 1e-9);
    EXPECT_EQ(demos::psnrDb(0, 1), HUGE_VAL);
}

TEST(Magma, IsNearTheTable) {
    // Entries 0, 64, 128, 192 and 255 of matplotlib's table.
    constexpr double table[][3] = {{0.001462, 0.000466, 0.013866},
                                   {0.316654, 0.071690, 0.485380},
                                   {0.716387, 0.214982, 0.475290},
                                   {0.986700, 0.535582, 0.382210},
                                   {0.987053, 0.991438, 0.749504}};
    constexpr int entries[] = {0, 64, 128, 192, 255};
    for (size_t i = 0; i < 5; ++i) {
        const auto rgb = demos::magma(static_cast<float>(entries[i]) / 255);
        for (size_t channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(rgb[channel] / 255.0, table[i][channel], 0.03) << "entry " << entries[i];
        }
    }
}

TEST(Magma, GetsLighterAllTheWay) {
    double before = -1;
    for (int i = 0; i <= 16; ++i) {
        const auto rgb = demos::magma(static_cast<float>(i) / 16);
        const double now = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        EXPECT_GT(now, before);
        before = now;
    }
}

} // namespace
