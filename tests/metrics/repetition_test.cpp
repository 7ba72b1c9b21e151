#include "metrics/repetition/repetition.h"

#include <gtest/gtest.h>

#include "tests/metrics/painted.h"

namespace {

using tests::Painted;

/// Noise that comes again after `period` pixels both ways, over light that falls off.
Painted noise(int period) {
    constexpr int size = 128;
    Painted picture = tests::grey(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            uint32_t bits = static_cast<uint32_t>(x % period) * 0x9e3779b9u ^
                            static_cast<uint32_t>(y % period) * 0x85ebca6bu;
            bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du;
            bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
            const float falling = static_cast<float>(x + y) / 40;
            const float value = static_cast<float>(bits >> 16) / 65536 + falling * falling;
            for (int c = 0; c < 3; ++c) picture.at(x, y, c) = value;
        }
    return picture;
}

TEST(Repetition, IsFoundWhereItIs) {
    const Painted tiled = noise(32);
    const demos::Repetition found = demos::repetition(tiled.view());
    EXPECT_NEAR(found.most, 0.75, 0.03); // three quarters of the picture lie on itself
    EXPECT_EQ(std::abs(found.right) + found.down, 32);
}

TEST(Repetition, IsNoneOfNoiseUnderFallingLight) {
    const Painted endless = noise(1024);
    EXPECT_LT(demos::repetition(endless.view()).most, 0.04);
}

} // namespace
