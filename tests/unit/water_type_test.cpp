// Named waters against what optical oceanography measured, tinted ones against what was asked for.
#include <algorithm>
#include <cmath>
#include <string>

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

constexpr float tints[][3] = {{0.001f, 0.008f, 0.035f}, {0.33f, 0.33f, 0.33f}, {1e-9f, 0.1f, 0.33f}};
constexpr float visibilities[] = {0.05f, 7.0f, 1000.0f};

TEST(WaterType, ATintIsWhatDeepWaterSendsBack) {
    for (const auto& tint : tints)
        for (const float visibility : visibilities) {
            WaterCoefficients water{};
            ASSERT_TRUE(tintedWater(tint, visibility, &water, nullptr));
            double clearest = 1e9;
            for (int band = 0; band < 3; ++band) {
                const double a = water.absorption[band], bb = water.backscatter[band];
                EXPECT_NEAR(reflectance(water, band), double{tint[band]}, 1e-5 * double{tint[band]});
                EXPECT_TRUE(a >= 0 && a <= 100 && bb >= 0 && bb <= 100) << a << ' ' << bb;
                clearest = std::min(clearest, a + bb);
            }
            EXPECT_NEAR(std::exp(-clearest * double{visibility}), 0.05, 1e-5);
        }
}

TEST(WaterType, TintedWaterScattersAllChannelsAlike) {
    WaterCoefficients water{};
    ASSERT_TRUE(tintedWater(tints[0], 7, &water, nullptr));
    EXPECT_FLOAT_EQ(water.backscatter[0], water.backscatter[2]);
    EXPECT_FLOAT_EQ(water.backscatter[1], water.backscatter[2]);
}

TEST(WaterType, BadTintsAreNamedAndLeaveNothing) {
    const float good[3] = {0.1f, 0.1f, 0.1f};
    WaterCoefficients water{{1, 2, 3}, {4, 5, 6}};
    const auto expectRefused = [&](const float* tint, float visibility, const char* field) {
        SeaError error;
        EXPECT_FALSE(tintedWater(tint, visibility, &water, &error)) << field;
        EXPECT_NE(std::string(error.text).find(field), std::string::npos) << error.text;
        EXPECT_FALSE(tintedWater(tint, visibility, &water, nullptr));
        EXPECT_EQ(water.absorption[0], 1);
        EXPECT_EQ(water.backscatter[2], 6);
    };
    const char* const names[] = {"tint[0] is ", "tint[1] is ", "tint[2] is "};
    for (int band = 0; band < 3; ++band)
        for (const float bad : {0.0f, -0.1f, 0.331f, 1.0f, NAN, INFINITY}) {
            float tint[3] = {0.1f, 0.1f, 0.1f};
            tint[band] = bad;
            expectRefused(tint, 5, names[band]);
        }
    for (const float bad : {0.0f, -1.0f, 0.04f, 1001.0f, NAN, INFINITY})
        expectRefused(good, bad, "visibility is ");
    expectRefused(nullptr, 5, "tint is null");
    SeaError error;
    EXPECT_FALSE(tintedWater(good, 5, nullptr, &error));
    EXPECT_NE(std::string(error.text).find("out is null"), std::string::npos) << error.text;
    EXPECT_TRUE(tintedWater(good, 5, &water, &error));
    EXPECT_EQ(error.text[0], 0);
}

} // namespace
