// What a bed makes of a sea, against theory worked out here anew.
#include "tests/unit/sea/sea_support.h"
#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

using namespace seaglass;
using namespace tests;

namespace {

constexpr double g = 9.81, pi = std::numbers::pi;

/// A plane that rises towards +v; the water's edge is at v = 0.
struct PlaneBeach {
    double slope = 1.0 / 30;
    SeaDesc sea;
    ShoreDesc shore;
    std::vector<float> bed;

    explicit PlaneBeach(double swellHeight, double towardsDegrees = 90) {
        constexpr uint32_t across = 121, along = 461;
        shore.spacing = 1;
        shore.samples[0] = across;
        shore.samples[1] = along;
        shore.origin[0] = -60;
        shore.origin[1] = -430;
        for (uint32_t j = 0; j < along; ++j)
            for (uint32_t i = 0; i < across; ++i)
                bed.push_back(static_cast<float>(slope * (shore.origin[1] + j)));
        shore.bed = bed.data();
        sea.windSpeed = 0;
        sea.swells[0] = {static_cast<float>(swellHeight), 5.0f, static_cast<float>(towardsDegrees * pi / 180),
                         0.1f, 60};
        sea.samples = 64;
        sea.cascades = 2;
        sea.shore = &shore;
    }
    SeaPtr make() const { return makeSea(sea); }
};

/// w^2 = g k tanh(k d), by Newton's method.
double waveNumberAt(double omega, double depth) {
    double k = omega * omega / g / std::sqrt(std::tanh(omega * omega * depth / g));
    for (int i = 0; i < 30; ++i) {
        const double t = std::tanh(k * depth);
        k -= (g * k * t - omega * omega) / (g * t + g * k * depth * (1 - t * t));
    }
    return k;
}

double groupSpeedAt(double omega, double depth) {
    const double k = waveNumberAt(omega, depth);
    return omega / k * 0.5 * (1 + 2 * k * depth / std::sinh(2 * k * depth));
}

TEST(Shore, WavesGrowAsTheirEnergyFluxSaysAndAsGreensLawWhereItIsShallow) {
    const PlaneBeach beach(0.02); // too low to break
    const SeaPtr sea = beach.make();
    const Shore& shore = *sea->shore;
    const double omega = 2 * pi / 5, offshore = g / (2 * omega);
    const double deviation = significantWaveHeight(*sea) / 4;
    std::printf("depth, over the sea's: theory\n");
    for (const double depth : {1.8, 1.2, 0.8, 0.5, 0.3}) {
        const double seen = double{shore.at(0, -depth / beach.slope).height} / deviation;
        const double theory = std::sqrt(offshore / groupSpeedAt(omega, depth));
        std::printf("%.1f m, %.3f: %.3f\n", depth, seen, theory);
        EXPECT_NEAR(seen, theory, 0.03 * theory) << depth;
    }
    const auto height = [&](double depth) { return double{shore.at(0, -depth / beach.slope).height}; };
    EXPECT_NEAR(height(0.3) / height(0.6), std::pow(2.0, 0.25), 0.03) << "Green";
    EXPECT_EQ(height(12), 0) << "the sea's own waves are there yet";
}

TEST(Shore, NothingOfTheSeasEnergyIsLostWhereTrainsTakeOver) {
    const PlaneBeach beach(0.02);
    const SeaPtr sea = beach.make();
    const double omega = 2 * pi / 5, offshore = g / (2 * omega);
    for (double depth = 2; depth < 12; depth += 0.5) {
        const ShorePlace place = sea->shore->at(0, -depth / beach.slope);
        const double grown = double{place.height} / std::sqrt(offshore / groupSpeedAt(omega, depth));
        double variance = grown * grown;
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c)
            variance += cascade(*sea, c).variance * std::pow(double{place.kept[c]}, 2);
        EXPECT_NEAR(4 * std::sqrt(variance) / significantWaveHeight(*sea), 1, 0.03) << depth;
    }
}

TEST(Shore, CrestsTurnAsSnellsLawSays) {
    const double degrees = 55; // from +u towards +v: 35 degrees off the normal of the shore
    const PlaneBeach beach(0.3, degrees);
    const SeaPtr sea = beach.make();
    const double omega = 2 * pi / 5, deepest = 430 * beach.slope;
    const double perMetre = std::cos(degrees * pi / 180) * waveNumberAt(omega, deepest);
    for (const double depth : {8.0, 4.0, 2.0, 1.0, 0.4}) {
        const double v = -depth / beach.slope, apart = 2;
        const auto arrival = [&](double u, double w) { return double{sea->shore->at(u, w).arrival[1]}; };
        const double du = (arrival(30 + apart, v) - arrival(30 - apart, v)) / (2 * apart);
        const double dv = (arrival(30, v + apart) - arrival(30, v - apart)) / (2 * apart);
        const double off = std::atan2(du, dv) * 180 / pi;
        const double expected = std::asin(perMetre / waveNumberAt(omega, depth)) * 180 / pi;
        std::printf("%.1f m: %.1f degrees off the shore's normal, Snell %.1f\n", depth, off, expected);
        EXPECT_NEAR(off, expected, 2.5) << depth;
        EXPECT_NEAR(std::hypot(du, dv) * omega, waveNumberAt(omega, depth),
                    0.04 * waveNumberAt(omega, depth));
    }
}

TEST(Shore, WavesBreakAtAShareOfTheDepth) {
    const PlaneBeach beach(1.5);
    const SeaPtr sea = beach.make();
    for (double depth = 0.1; depth < 12; depth += 0.1) {
        const ShorePlace place = sea->shore->at(0, -depth / beach.slope);
        EXPECT_LE(4 * double{place.height}, 0.6 * depth + 1e-6) << depth;
        if (depth < 1.5) {
            EXPECT_GT(place.breaking, 0.5f) << depth;
        }
        if (depth > 8) {
            EXPECT_LT(place.breaking, 0.1f) << depth;
        }
    }
    EXPECT_EQ(sea->shore->at(0, 10).height, 0) << "land";
}

/// What a train's row says at a place.
struct Seen {
    double height, foam, wetTo, depth;
};

Seen seen(const Shore& shore, double time, double v) {
    const ShoreWave wave = shore.waveAt(shore.signalAt(time, 3), 0, v, 0);
    return {wave.height, wave.foam, wave.wetTo, wave.depth};
}

TEST(Shore, CrestsRunInAtTheSpeedOfTheirDepth) {
    const PlaneBeach beach(0.1);
    const SeaPtr sea = beach.make();
    // Over a short way all trains take about as long: what is seen here is seen there a little later.
    const double from = -45, to = -39, depth = 42 * beach.slope;
    const double takes = (to - from) * waveNumberAt(2 * pi / 5, depth) / (2 * pi / 5);
    double later = 0, earlier = 0, same = 0;
    for (double time = 20; time < 60; time += 1) {
        const double here = seen(*sea->shore, time, from).height;
        later += std::abs(seen(*sea->shore, time + takes, to).height - here);
        earlier += std::abs(seen(*sea->shore, time - takes, to).height - here);
        same += std::abs(here);
    }
    std::printf("off by %.3f of the height towards the shore, %.3f away from it\n", later / same,
                earlier / same);
    EXPECT_LT(later, 0.15 * same);
    EXPECT_GT(earlier, 0.6 * same);
}

TEST(Shore, TheEdgeRunsUpAndDownTheBeachAsHuntSays) {
    const PlaneBeach beach(0.8);
    const SeaPtr sea = beach.make();
    const double height = significantWaveHeight(*sea);
    const double hunt = beach.slope * std::sqrt(height * g * 25 / (2 * pi)); // tan(beta) sqrt(H L0)
    EXPECT_NEAR(sea->shore->runUp(), hunt, 0.02 * hunt);
    double highest = -1, lowest = 1;
    for (double time = 0; time < 120; time += 0.5) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3);
        double edge = -1;
        for (double v = -12; v < 12; v += 0.25) {
            const ShoreWave here = sea->shore->waveAt(signal, 0, v, 0);
            if (here.height > -here.depth) edge = std::max(edge, v * beach.slope);
        }
        highest = std::max(highest, edge);
        lowest = std::min(lowest, edge);
    }
    std::printf("run-up %.2f m, run-down %.2f m, Hunt %.2f m\n", highest, lowest, hunt);
    EXPECT_GT(highest, 0.5 * hunt);
    EXPECT_LT(highest, 1.2 * hunt);
    EXPECT_LT(lowest, -0.05 * hunt);
    EXPECT_GT(lowest, -0.6 * hunt);
}

TEST(Shore, TroughsLeaveWaterOnTheBed) {
    for (const double swell : {0.3, 2.5}) {
        const PlaneBeach beach(swell);
        const SeaPtr sea = beach.make();
        const double dries = 0.6 * sea->shore->runUp();
        std::vector<double> points;
        for (double depth = dries; depth < 3; depth *= 1.08)
            points.insert(points.end(), {3.5, -depth / beach.slope});
        std::vector<HeightSample> samples(points.size() / 2);
        double least = 1;
        for (double time = 0; time < 60; time += 1.7) {
            sampleHeights(*sea, time, points.data(), samples.size(), samples.data());
            for (size_t i = 0; i < samples.size(); ++i) {
                const double depth = -points[2 * i + 1] * beach.slope;
                least = std::min(least, (double{samples[i].height} + depth) / depth);
            }
        }
        std::printf("least share of the depth left under a trough of %.1f m swell: %.2f\n", swell, least);
        EXPECT_GT(least, 0);
    }
}

TEST(Shore, FoamLiesWhereWavesBreak) {
    const PlaneBeach beach(0.8);
    const SeaPtr sea = beach.make();
    double deep = 0, shallow = 0;
    for (double time = 0; time < 40; time += 0.5) {
        deep = std::max(deep, seen(*sea->shore, time, -9 / beach.slope).foam);
        shallow = std::max(shallow, seen(*sea->shore, time, -0.6 / beach.slope).foam);
    }
    EXPECT_LT(deep, 0.02);
    EXPECT_GT(shallow, 0.7);
}

TEST(Shore, IsAFunctionOfTheTimeAlone) {
    const PlaneBeach beach(0.6);
    const SeaPtr sea = beach.make(), again = beach.make();
    const ShoreSignal one = sea->shore->signalAt(77.3, 3.85), two = again->shore->signalAt(77.3, 3.85);
    ASSERT_EQ(one.rows.size(), two.rows.size());
    for (size_t i = 0; i < one.rows.size(); ++i) ASSERT_EQ(one.rows[i].wet, two.rows[i].wet);
    // A little later everything is nearly as it was: history is stepped on a grid of its own.
    for (double time = 77.3; time < 79; time += 0.031)
        for (const double v : {-40.0, -12.0, -1.0, 1.0}) {
            const Seen now = seen(*sea->shore, time, v), next = seen(*sea->shore, time + 0.001, v);
            EXPECT_NEAR(now.height, next.height, 0.01) << time;
            EXPECT_NEAR(now.foam, next.foam, 0.02) << time;
            EXPECT_NEAR(now.wetTo, next.wetTo, 0.01) << time;
        }
}

TEST(Shore, WavesThatRunFromTheLandHaveNoTrains) {
    const PlaneBeach beach(0.8, 270);
    const SeaPtr sea = beach.make();
    for (double v = -400; v < 20; v += 10) {
        EXPECT_EQ(sea->shore->at(0, v).height, 0);
        EXPECT_EQ(sea->shore->at(0, v).swash, 0);
    }
}

TEST(Shore, FarOffTheSeaIsWhatItIsWithoutABed) {
    PlaneBeach beach(0.4);
    const SeaPtr with = beach.make();
    beach.sea.shore = nullptr;
    const SeaPtr without = beach.make();
    EXPECT_FALSE(without->shore.has_value());
    const double points[] = {0, -425, 20, -410};
    HeightSample a[2], b[2];
    sampleHeights(*with, 5, points, 2, a);
    sampleHeights(*without, 5, points, 2, b);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(a[i].height, b[i].height, 2e-3);
}

TEST(Shore, ItsNormalsAreThoseOfItsHeights) {
    const PlaneBeach beach(0.3);
    const SeaPtr sea = beach.make();
    const double step = 0.05;
    for (const double v : {-80.0, -50.0, -31.3}) {
        const double points[] = {2, v, 2 + step, v, 2, v + step};
        HeightSample s[3];
        sampleHeights(*sea, 9, points, 3, s);
        const double slopeU = double{s[1].height - s[0].height} / step,
                     slopeV = double{s[2].height - s[0].height} / step;
        EXPECT_NEAR(-double{s[0].normal[0] / s[0].normal[1]}, slopeU, 0.02) << v;
        EXPECT_NEAR(-double{s[0].normal[2] / s[0].normal[1]}, slopeV, 0.02) << v;
    }
}

TEST(Shore, GridsAnswerAsTheSum) {
    const PlaneBeach beach(0.5);
    const SeaPtr sea = beach.make();
    HeightGrid* const grid = createHeightGrid(*sea, 12);
    const double points[] = {0, -30, 5, -2, -7, -200};
    HeightSample a[3], b[3];
    sampleHeights(*grid, points, 3, a);
    sampleHeights(*sea, 12, points, 3, b);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(a[i].height, b[i].height);
    destroyHeightGrid(grid);
}

TEST(Shore, BadFieldsAreNamed) {
    PlaneBeach beach(0.5);
    const auto refused = [&](const char* words) {
        SeaError error;
        Sea* const sea = createSea(&beach.sea, &error);
        EXPECT_EQ(sea, nullptr);
        EXPECT_NE(std::string(error.text).find(words), std::string::npos) << error.text;
        destroySea(sea);
    };
    const ShoreDesc good = beach.shore;
    beach.shore.bed = nullptr;
    refused("ShoreDesc.bed is null");
    beach.shore = good;
    beach.shore.samples[0] = 1;
    refused("ShoreDesc.samples[0] is 1");
    beach.shore = good;
    beach.shore.samples[1] = 2000;
    refused("ShoreDesc.samples[1] is 2000");
    beach.shore = good;
    for (const float bad : {0.0f, NAN}) {
        beach.shore.spacing = bad;
        refused("ShoreDesc.spacing");
    }
    beach.shore = good;
    beach.shore.origin[1] = std::numeric_limits<double>::infinity();
    refused("ShoreDesc.origin[1]");
    beach.shore = good;
    beach.bed[37] = NAN;
    refused("ShoreDesc.bed[37]");
}

} // namespace
