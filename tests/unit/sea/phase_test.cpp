#include "water/sea/phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace seaglass;

constexpr double day = 86400, year = 365.25 * day;

TEST(Phase, FrequenciesAreWholeMultiplesAndNeverStill) {
    EXPECT_EQ(frequencyIndex(1.0, 4096), 652u); // 651.9
    EXPECT_EQ(frequencyIndex(1e-9, 16), 1u);
    EXPECT_EQ(frequencyIndex(4291.0, 1e6), 682933861u);
}

// An independent reduction: the loop is a power of two, so that the fraction of a time in whole 1/1024 s is
// an integer.
TEST(Phase, IsExactAtAnyTime) {
    for (const double time : {0.0, 0.25, 4095.75, 4096.0, 30 * day + 0.125, year + 0.0009765625, 1e9 + 0.5,
                              1e12, -0.25, -1e9 - 0.5}) {
        const auto ticks = static_cast<int64_t>(time * 1024);
        const auto fraction = static_cast<uint32_t>((static_cast<uint64_t>(ticks) & 0x3fffffu) << 10);
        EXPECT_EQ(loopPhase(time, 4096), fraction) << time;
        EXPECT_EQ(wavePhase(12345, loopPhase(time, 4096)), static_cast<uint32_t>(12345ull * fraction))
            << time;
    }
}

TEST(Phase, TakesAnyTime) {
    for (const double time : {1e300, -1e300, 5e-324, -5e-324, 4096 - 1e-12}) {
        const uint32_t loops = loopPhase(time, 4096);
        EXPECT_EQ(loops, loopPhase(std::fmod(time, 4096), 4096)) << time;
    }
    EXPECT_EQ(loopPhase(std::numeric_limits<double>::infinity(), 4096), 0u);
    EXPECT_EQ(loopPhase(std::numeric_limits<double>::quiet_NaN(), 4096), 0u);
    EXPECT_EQ(loopPhase(4096 - 1e-12, 4096), 0u) << "rounds up to a whole loop";
}

TEST(Phase, SineAndCosineAreAccurateToAFloat) {
    double worst = 0;
    for (uint64_t p = 0; p < (1ull << 32); p += 4099) {
        const auto phase = static_cast<uint32_t>(p);
        const SineCosine found = sineCosine(phase);
        worst = std::max({worst, std::abs(static_cast<double>(found.sine) - std::sin(radians(phase))),
                          std::abs(static_cast<double>(found.cosine) - std::cos(radians(phase)))});
    }
    EXPECT_LT(worst, 1.3e-7);
    EXPECT_EQ(sineCosine(0).sine, 0.0f);
    EXPECT_EQ(sineCosine(0).cosine, 1.0f);
    EXPECT_EQ(sineCosine(0x40000000u).sine, 1.0f);
    EXPECT_EQ(sineCosine(0x80000000u).cosine, -1.0f);
}

} // namespace
