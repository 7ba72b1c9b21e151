#include "water/interface/foam_gate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace seaglass;

TEST(FoamGate, IsOpenAsOftenAsItSays) {
    for (const double time : {0.0, 17.3, 4000.0}) {
        const FoamGate gate(SeaDesc{}, time);
        double sum = 0;
        constexpr int across = 300;
        for (int i = 0; i < across; ++i)
            for (int j = 0; j < across; ++j)
                sum += static_cast<double>(gate.at(0.137 * i - 20, 0.151 * j - 9));
        EXPECT_NEAR(sum / (across * across) / foamGateMean, 1, 0.04) << time;
    }
}

TEST(FoamGate, IsAnotherOneATileAway) {
    const FoamGate gate(SeaDesc{}, 3);
    double both = 0, alone = 0;
    for (int i = 0; i < 400; ++i) {
        const double u = 0.0437 * i, v = 1.3 * i;
        const double here = double{gate.at(u, v)} - foamGateMean,
                     there = double{gate.at(u + 1, v)} - foamGateMean;
        alone += here * here;
        both += here * there;
    }
    EXPECT_LT(std::abs(both), 0.25 * alone);
}

TEST(FoamGate, LoopsExactlyAndGlides) {
    const SeaDesc sea;
    for (int i = 0; i < 50; ++i) {
        const double u = 0.217 * i + 1e6, v = -3.1 * i;
        const float now = FoamGate(sea, 12.5).at(u, v);
        EXPECT_EQ(now, FoamGate(sea, 12.5 + 4096 * 1000.0).at(u, v));
        EXPECT_NEAR(now, FoamGate(sea, 12.55).at(u, v), 0.05);
    }
}

TEST(FoamGate, IsNoneWhereTilesRepeat) {
    SeaDesc sea;
    sea.warp = 0;
    EXPECT_EQ(FoamGate(sea, 5).at(0.3, 7.7), 1);
    EXPECT_EQ(FoamGate(sea, 5).mean(), 1);
}

} // namespace
