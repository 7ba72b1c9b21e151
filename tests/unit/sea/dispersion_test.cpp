#include "water/spectrum/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace seaglass;

double ofLength(double wavelength) {
    return 2 * std::numbers::pi / wavelength;
}

TEST(Dispersion, MatchesPublishedFrequencies) {
    EXPECT_NEAR(angularFrequency(ofLength(100)), 0.785099, 1e-6);
    EXPECT_NEAR(angularFrequency(ofLength(100), 10), 0.585882, 1e-6);
    EXPECT_NEAR(angularFrequency(ofLength(1)), 7.8522, 1e-4);
    EXPECT_NEAR(angularFrequency(ofLength(5e-3)), 398.97, 0.01);
}

TEST(Dispersion, SlowestWaveIsACapillaryOne) {
    double slowest = 1e9, at = 0;
    for (double wavelength = 5e-3; wavelength < 0.1; wavelength += 1e-5) {
        const double k = ofLength(wavelength);
        const double speed = angularFrequency(k) / k;
        if (speed < slowest) slowest = speed, at = wavelength;
    }
    EXPECT_NEAR(slowest, 0.2321, 1e-4);
    EXPECT_NEAR(at, 17.26e-3, 2e-5);
}

TEST(Dispersion, GroupSpeedIsTheSlopeOfFrequency) {
    for (const double depth : {1.0, 10.0, deepWater}) {
        for (const double wavelength : {0.01, 1.0, 30.0, 300.0}) {
            const double k = ofLength(wavelength), step = 1e-5 * k;
            const double slope =
                (angularFrequency(k + step, depth) - angularFrequency(k - step, depth)) / (2 * step);
            EXPECT_NEAR(groupSpeed(k, depth) / slope, 1, 1e-7) << wavelength << " m over " << depth << " m";
        }
    }
}

TEST(Dispersion, WaveNumberIsItsInverse) {
    for (const double depth : {1e-6, 0.5, 10.0, deepWater})
        for (const double k : {1e-6, 1e-3, 1.0, 365.0, 6000.0})
            EXPECT_NEAR(waveNumber(angularFrequency(k, depth), depth) / k, 1, 1e-12) << k << ", " << depth;
}

TEST(Dispersion, IsFiniteFromNoDepthToNoBottom) {
    const double k = ofLength(100);
    EXPECT_EQ(angularFrequency(k, 0), 0);
    EXPECT_GT(angularFrequency(k, 1e-6), 0);
    EXPECT_EQ(angularFrequency(k, 1e30), angularFrequency(k));
    EXPECT_EQ(groupSpeed(k, 1e30), groupSpeed(k));
    EXPECT_EQ(groupSpeed(k, 0), 0);
    EXPECT_EQ(angularFrequency(0), 0);
    EXPECT_EQ(groupSpeed(0), 0);
}

} // namespace
