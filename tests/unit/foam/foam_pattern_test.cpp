#include "water/foam/foam_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace seaglass;

/// Deviation of linear samples at places all over the tile.
double deviationBetween(const std::vector<FoamTexel>& mip, size_t across) {
    double squares = 0;
    constexpr size_t samples = 20000;
    for (size_t n = 0; n < samples; ++n) {
        const double x =
            std::fmod(static_cast<double>(n) * 0.7548776662466927, 1) * static_cast<double>(across);
        const double y =
            std::fmod(static_cast<double>(n) * 0.5698402909980532, 1) * static_cast<double>(across);
        const auto at = [&](size_t i, size_t j) {
            const size_t column = (static_cast<size_t>(x) + i) % across,
                         row = (static_cast<size_t>(y) + j) % across;
            return static_cast<double>(mip[row * across + column].pattern) - 127.5;
        };
        const double u = x - std::floor(x), v = y - std::floor(y);
        const double found = std::lerp(std::lerp(at(0, 0), at(1, 0), u), std::lerp(at(0, 1), at(1, 1), u), v);
        squares += found * found;
    }
    return std::sqrt(squares / samples);
}

// What shaders/water/foam/foam_cover.glsl relies on, so that a share `cover` is white where the pattern is a
// mip's.
TEST(FoamPattern, IsEvenInEveryMipAndKeepsItsContrast) {
    const auto mips = foamPattern();
    ASSERT_EQ(mips.size(), 9u);
    for (size_t m = 0; m + 3 < mips.size(); ++m) { // fewer texels are too few
        const size_t across = foamPatternSamples >> m;
        ASSERT_EQ(mips[m].size(), across * across);
        std::vector<double> sorted;
        for (const FoamTexel& texel : mips[m]) sorted.push_back(static_cast<double>(texel.pattern));
        std::ranges::sort(sorted);
        const double least = sorted.front(), most = sorted.back();
        EXPECT_NEAR((least + most) / 2, 127.5, 1) << across;
        for (const double share : {0.05, 0.1, 0.25, 0.5, 0.75, 0.9}) {
            const double found = sorted[static_cast<size_t>(share * static_cast<double>(sorted.size()))];
            EXPECT_NEAR(found, std::lerp(least, most, share), 1.5 + 0.02 * (most - least))
                << across << ' ' << share;
        }
        const double kept = deviationBetween(mips[m], across) * std::sqrt(12.0) / 255;
        EXPECT_NEAR(kept, 30 / (29.15 + std::exp2(m)), 0.02) << across;
    }
    EXPECT_NEAR(static_cast<double>(mips.back()[0].pattern), 127.5, 0.6);
}

} // namespace
