#include "water/interface/foam_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "water/interface/sea_contents.h"

namespace {

using namespace seaglass;

using SeaPointer = std::unique_ptr<Sea, void (*)(Sea*)>;

SeaPointer made(const SeaDesc& desc) {
    return {createSea(&desc, nullptr), destroySea};
}

TEST(FoamGate, IsOpenAsOftenAsItSays) {
    const SeaPointer sea = made(SeaDesc());
    for (const double time : {0.0, 17.3, 4000.0}) {
        const FoamGate gate(*sea, time);
        double sum = 0;
        constexpr int across = 300;
        for (int i = 0; i < across; ++i)
            for (int j = 0; j < across; ++j)
                sum += static_cast<double>(gate.at(0.137 * i - 20, 0.151 * j - 9));
        EXPECT_NEAR(sum / (across * across) / foamGateMean, 1, 0.04) << time;
    }
}

TEST(FoamGate, IsAnotherOneATileAway) {
    const SeaPointer sea = made(SeaDesc());
    const FoamGate gate(*sea, 3);
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
    const SeaPointer sea = made(SeaDesc());
    for (int i = 0; i < 50; ++i) {
        const double u = 0.217 * i + 1e6, v = -3.1 * i;
        const float now = FoamGate(*sea, 12.5).at(u, v);
        EXPECT_EQ(now, FoamGate(*sea, 12.5 + 4096 * 1000.0).at(u, v));
        EXPECT_NEAR(now, FoamGate(*sea, 12.55).at(u, v), 0.05);
    }
}

TEST(FoamGate, IsNoneWhereTilesRepeat) {
    SeaDesc desc;
    desc.warp = 0;
    const SeaPointer sea = made(desc);
    EXPECT_EQ(FoamGate(*sea, 5).at(0.3, 7.7), 1);
    EXPECT_EQ(FoamGate(*sea, 5).mean(), 1);
}

// As on a beach that a swell runs up: its tile is over a hundred times as long as the waves that break.
TEST(FoamGate, GroupsThreeOfTheWindsWaves) {
    SeaDesc desc;
    desc.windSpeed = 25;
    desc.fetch = 4000;
    desc.swells[0].height = 1.6f;
    desc.swells[0].peakPeriod = 9;
    const SeaPointer sea = made(desc);
    const double tile = cascade(*sea, 0).patch;
    desc.swells[0].height = 0;
    const SeaPointer wind = made(desc);
    const double length = 2 * std::numbers::pi * 9.81 / std::pow(peakFrequency(*wind), 2);
    const FoamGate gate(*sea, 5);
    std::printf("a tile of %.0f m, waves of %.1f m, cells of %.1f m\n", tile, length, tile / gate.cells());
    EXPECT_GT(tile, 100 * length);
    EXPECT_NEAR(tile / gate.cells() / length, 3, 0.1);
    EXPECT_EQ(FoamGate(*wind, 5).cells(), 6);
}

} // namespace
