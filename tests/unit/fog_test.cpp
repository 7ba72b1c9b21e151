// What share of light fog lets through: held against a sum over the way, and at extremes.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "seaglass/fog.h"

namespace {

using namespace seaglass;

FogDesc heightFog(float density, float falloff) {
    FogDesc fog;
    fog.shape = FogShape::height;
    fog.density = density;
    fog.falloff = falloff;
    fog.baseHeight = 3;
    return fog;
}

/// By Simpson's rule.
double summed(const FogDesc& fog, double from, double rise, double way) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double y = from + rise * i / steps - fog.baseHeight;
        const double weight = i == 0 || i == steps ? 1 : i % 2 ? 4 : 2;
        sum += weight * std::exp(-double{fog.falloff} * y);
    }
    return std::exp(-double{fog.density} * way * sum / (3 * steps));
}

TEST(Fog, OfHeightIsTheIntegralAlongTheWay) {
    for (const float falloff : {0.0f, 1e-6f, 0.01f, 0.3f})
        for (const double from : {-5.0, 2.0, 40.0})
            for (const double rise : {-30.0, -1e-9, 0.0, 1e-5, 0.02, 250.0}) {
                const double way = std::max(300.0, std::abs(rise));
                const FogDesc fog = heightFog(0.002f, falloff);
                EXPECT_NEAR(fogTransmittance(fog, from, rise, way), summed(fog, from, rise, way), 1e-9)
                    << falloff << " from " << from << " by " << rise;
            }
}

TEST(Fog, HasItsFormulas) {
    FogDesc fog;
    fog.density = 0.01f;
    fog.most = 0.75f;
    const double d = double{fog.density};
    EXPECT_NEAR(fogTransmittance(fog, 0, 5, 120), 0.25 + 0.75 * std::exp(-d * 120), 1e-12);
    fog.shape = FogShape::exponentialSquared;
    EXPECT_NEAR(fogTransmittance(fog, 0, 5, 120), 0.25 + 0.75 * std::exp(-d * d * 120 * 120), 1e-12);
    fog.shape = FogShape::linear;
    fog.start = 100;
    fog.end = 300;
    EXPECT_EQ(fogTransmittance(fog, 0, 5, 99), 1);
    EXPECT_NEAR(fogTransmittance(fog, 0, 5, 150), 0.25 + 0.75 * 0.75, 1e-12);
    EXPECT_EQ(fogTransmittance(fog, 0, 5, 300), 0.25);
}

TEST(Fog, IsAShareAtExtremesAndFallsWithDistance) {
    const double ways[] = {0, 1e-6, 1, 1e3, 1e6, 1e9, 1e30, std::numeric_limits<double>::max()};
    for (const float density : {0.0f, 1e-9f, 1.0f, 1000.0f})
        for (const float falloff : {0.0f, 1e-7f, 10.0f})
            for (const double from : {-1e6, -100.0, 0.0, 1e6})
                for (const double steepness : {-1.0, -1e-12, 0.0, 1e-12, 1.0})
                    for (const FogShape shape : {FogShape::linear, FogShape::exponential,
                                                 FogShape::exponentialSquared, FogShape::height}) {
                        FogDesc fog = heightFog(density, falloff);
                        fog.shape = shape;
                        double before = 1;
                        for (const double way : ways) {
                            const double passes = fogTransmittance(fog, from, steepness * way, way);
                            ASSERT_TRUE(passes >= 0 && passes <= before + 1e-12)
                                << passes << " after " << before << ", shape " << static_cast<int>(shape)
                                << ", density " << density << ", falloff " << falloff << ", from " << from
                                << ", steepness " << steepness << ", way " << way;
                            before = passes;
                        }
                    }
}

TEST(Fog, HandsShadersNothingThatItsShapeDoesNotRead) {
    FogDesc fog;
    fog.shape = FogShape::exponential;
    fog.start = fog.end = fog.falloff = std::numeric_limits<float>::quiet_NaN();
    fog.baseHeight = HUGE_VAL;
    const FogBlock exponential = fogBlock(fog, 2);
    EXPECT_EQ(exponential.form[0], fog.density);
    for (const float number :
         {exponential.form[1], exponential.form[2], exponential.reach[0], exponential.reach[1]})
        EXPECT_EQ(number, 0);
    fog.shape = FogShape::linear;
    fog.density = std::numeric_limits<float>::quiet_NaN();
    fog.start = 100;
    fog.end = 300;
    const FogBlock linear = fogBlock(fog, 2);
    EXPECT_EQ(linear.reach[0], 300);
    EXPECT_EQ(linear.reach[1], 1 / 200.0f);
    for (const float number : {linear.form[0], linear.form[1], linear.form[2]}) EXPECT_EQ(number, 0);
}

// Straight up through all of it: density / falloff at the base.
TEST(Fog, AboveIsFinite) {
    const FogDesc fog = heightFog(0.05f, 0.02f);
    const double all = double{fog.density} / double{fog.falloff};
    EXPECT_NEAR(fogTransmittance(fog, fog.baseHeight, 1e9, 1e9), std::exp(-all), 1e-9);
    EXPECT_NEAR(fogTransmittance(fog, fog.baseHeight, 0.5e30, 1e30), std::exp(-2 * all), 1e-9);
    EXPECT_EQ(fogTransmittance(fog, fog.baseHeight, -1e9, 1e9), 0);
}

} // namespace
