// Named waters against what optical oceanography measured.
#include <cmath>

#include <gtest/gtest.h>

#include "seaglass/water.h"
#include "seaglass/water_type.h"

namespace {

using namespace seaglass;

/// Irradiance reflectance just below the surface, as the shaders have it.
double reflectance(const WaterCoefficients& water, int band) {
    const double a = water.absorption[band], bb = water.backscatter[band];
    return 0.33 * bb / (a + bb);
}

/// Of the open ocean, by the statistics of Morel and Maritorena (2001): the attenuation of daylight by their
/// table 2, backscatter by their eq. 12, and their eq. 8' between them.
struct OpenOcean {
    double wavelength;    ///< [nm]
    double pureKd;        ///< Pope and Fry 1997, and half of what Morel (1974) has scattered [1/m]
    double pureBb;        ///< that half [1/m]
    double factor, power; ///< of chlorophyll in Kd

    double backscatter(double chlorophyll) const {
        const double decades = std::log10(chlorophyll);
        const double slope = std::pow(wavelength / 550, 0.5 * (decades - 0.3));
        return pureBb +
               (0.002 + 0.01 * (0.5 - 0.25 * decades) * slope) * 0.416 * std::pow(chlorophyll, 0.766);
    }
    double reflectance(double chlorophyll) const {
        const double kd = pureKd + factor * std::pow(chlorophyll, power);
        double r = 0;
        for (int i = 0; i < 20; ++i)
            r = 0.33 * backscatter(chlorophyll) / (0.9 * kd * (1 - r) / (1 + 2.25 * r));
        return r;
    }
};

constexpr OpenOcean bands[] = {
    {650, 0.34046, 0.00046, 0.04500, 0.67200},
    {550, 0.05747, 0.00097, 0.04111, 0.64927},
    {450, 0.01149, 0.00227, 0.10165, 0.67692},
};

TEST(WaterType, TheClearOceanIsAsBlueAsMeasured) {
    const WaterCoefficients ocean = waterCoefficients(WaterType::clearOcean);
    for (int band = 0; band < 3; ++band) {
        const double published = bands[band].reflectance(0.1);
        EXPECT_NEAR(reflectance(ocean, band), published, 0.15 * published) << bands[band].wavelength;
        EXPECT_NEAR(ocean.backscatter[band], bands[band].backscatter(0.1), 5e-5) << bands[band].wavelength;
    }
}

// Daylight is dimmed by 1.25 (a + bb), Gordon 1989.
TEST(WaterType, CoastsDimDaylightAsJerlovMeasured) {
    const double measured[2][3] = {{0.45, 0.12, 0.25}, {0.54, 0.30, 0.56}};
    const double chlorophyll[2] = {2, 10};
    const WaterType types[2] = {WaterType::coastal, WaterType::turbid};
    for (int i = 0; i < 2; ++i) {
        const WaterCoefficients water = waterCoefficients(types[i]);
        for (int band = 0; band < 3; ++band) {
            EXPECT_NEAR(1.25 * double{water.absorption[band] + water.backscatter[band]}, measured[i][band],
                        1e-3);
            EXPECT_NEAR(water.backscatter[band], bands[band].backscatter(chlorophyll[i]), 5e-4);
        }
    }
}

TEST(WaterType, WaterIsTheClearOceanUnlessToldOtherwise) {
    const RefractionDesc refraction;
    const WaterCoefficients ocean = waterCoefficients(WaterType::clearOcean);
    for (int band = 0; band < 3; ++band) {
        EXPECT_EQ(refraction.absorption[band], ocean.absorption[band]);
        EXPECT_EQ(refraction.backscatter[band], ocean.backscatter[band]);
    }
}

} // namespace
