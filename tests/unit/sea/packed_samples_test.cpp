#include "water/sea/packed_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace {

using namespace seaglass;

constexpr std::array<float, 6> ways = {0, 1e-6f, 0.25f, 0.5f, 0.7731f, 1};

/// A cell's corners: at u = v = 0, at v = 1, at u = 1, at both. Without order, with the extremes.
struct Cell {
    std::array<std::array<int32_t, packedFields>, 4> corners;
    std::array<PackedSample, 2> samples;

    explicit Cell(uint32_t salt) {
        uint32_t state = salt;
        for (auto& corner : corners)
            for (int32_t& field : corner) {
                state = state * 1664525 + 1013904223;
                const uint32_t kind = (state >> 8) % 7, any = state >> 16;
                field = kind == 0   ? packedMost
                        : kind == 1 ? -packedMost
                                    : std::max(static_cast<int32_t>(any) - 32768, -packedMost);
            }
        for (size_t f = 0; f < packedFields; ++f)
            for (const size_t u : {0u, 1u})
                samples[u].pairs[f] = paired(Int4{} + corners[2 * u][f], Int4{} + corners[2 * u + 1][f])[0];
    }
    Corners at(float u, float v) const {
        const CornerShares shares = cornerShares(Float4{} + u, Float4{} + v);
        return {samples.data(), 1, shares.here[0], shares.next[0]};
    }
};

#if defined(__SSE2__)
TEST(PackedSamples, AreWeighedToTheSameBitsInBothForms) {
    for (uint32_t salt = 0; salt < 100; ++salt) {
        const Cell cell(salt);
        for (const float u : ways)
            for (const float v : ways)
                for (const size_t field : {0u, 4u, 8u}) {
                    const Corners corners = cell.at(u, v);
                    const Int4 one = fourBetweenPortably(corners, field);
                    const Int4 other = fourBetweenBySse2(corners, field);
                    ASSERT_EQ(std::memcmp(&one, &other, sizeof one), 0) << salt << ' ' << u << ' ' << v;
                }
    }
}
#endif

TEST(PackedSamples, AreThemselvesAtTheCornersAndLinearBetween) {
    for (uint32_t salt = 0; salt < 20; ++salt) {
        const Cell cell(salt);
        for (const float u : ways)
            for (const float v : ways) {
                const Float4 found = fourBetween(cell.at(u, v), 4);
                for (size_t f = 0; f < 4; ++f) {
                    const auto at = [&](size_t i) { return static_cast<double>(cell.corners[i][4 + f]); };
                    const double here = std::lerp(at(0), at(1), double{v});
                    const double next = std::lerp(at(2), at(3), double{v});
                    const bool corner = (u == 0 || u == 1) && (v == 0 || v == 1);
                    EXPECT_NEAR(double{found[f]} / packedMost, std::lerp(here, next, double{u}),
                                corner ? 0.002 : 3);
                }
            }
        EXPECT_EQ(fourOf(cell.samples[0], 4)[2], static_cast<float>(packedMost * cell.corners[0][6]));
    }
}

TEST(PackedSamples, KeepAFieldToAThirtyThousandth) {
    for (const float most : {1e-20f, 0.003f, 1.0f, 40.0f, 1e20f}) {
        const float scale = packedScale(most);
        for (const float share : {-1.0f, -0.4999f, -1e-5f, 0.0f, 1e-4f, 0.3f, 1.0f}) {
            PackedSample sample;
            sample.pairs[1] = paired(packed(Float4{} + share * most, scale), Int4{} + 77)[0];
            EXPECT_NEAR(fourOf(sample, 0)[1] * scale / most, share, 0.51 / packedMost) << most;
        }
    }
    for (const float nothing : {0.0f, std::numeric_limits<float>::denorm_min()}) {
        EXPECT_EQ(packedScale(nothing), 0);
        EXPECT_EQ(packed(Float4{} + nothing, packedScale(nothing))[3], 0);
    }
}

} // namespace
