#include "water/spectrum/spreading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace seaglass;

Spectrum windSea() {
    return makeSpectrum(SeaDesc{});
}

double shapeAt(SpreadingModel model, double ratio, double swell = 0, double shape = 0) {
    const Spectrum spectrum = windSea();
    return spreadAt({.model = model, .shape = shape, .swell = swell}, spectrum, ratio * spectrum.peak).shape;
}

double integral(const Spread& spread) {
    constexpr int steps = 20000;
    const double step = 2 * std::numbers::pi / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += density(spread, std::cos((i + 0.5) * step)) * step;
    return sum;
}

TEST(Spreading, NormMatchesPublishedValues) {
    EXPECT_NEAR(spreadingNorm(0), 0.5 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(spreadingNorm(1), 0.31831, 5e-6);
    EXPECT_NEAR(spreadingNorm(5), 0.64672, 5e-6);
    EXPECT_NEAR(spreadingNorm(16), 1.13723, 5e-6);
}

TEST(Spreading, CosinePowersIntegrateToOne) {
    for (const double shape : {0.0, 1e-3, 0.3, 1.0, 7.0, 16.0, 30.9, 31.0, 33.0, 200.0, 1e5})
        EXPECT_NEAR(integral({.norm = spreadingNorm(shape), .beta = 0, .shape = shape}), 1, 1e-5) << shape;
}

TEST(Spreading, EveryModelIntegratesToOneAtEveryFrequency) {
    const Spectrum spectrum = windSea();
    for (const auto model : {SpreadingModel::hasselmann, SpreadingModel::mitsuyasu,
                             SpreadingModel::donelanBanner, SpreadingModel::cosine2s}) {
        for (const double swell : {0.0, 0.1, 0.5, 1.0}) {
            for (const double ratio :
                 {1e-9, 0.3, 0.7, 0.949, 0.951, 1.0, 1.3, 1.59, 1.61, 3.0, 20.0, 500.0}) {
                const Spread spread =
                    spreadAt({.model = model, .shape = 7, .swell = swell}, spectrum, ratio * spectrum.peak);
                EXPECT_NEAR(integral(spread), 1, 1e-4)
                    << static_cast<int>(model) << " at " << ratio << " peaks, swell " << swell;
            }
        }
    }
}

TEST(Spreading, FollowsHasselmann) {
    const auto shape = [](double ratio) { return shapeAt(SpreadingModel::hasselmann, ratio); };
    EXPECT_NEAR(shape(1), 6.97, 1e-9);
    EXPECT_NEAR(shape(0.5), 6.97 * std::pow(0.5, 4.06), 1e-9);
    // U wp / g = 22 chi^(-1/3), and chi is held at 1e4.
    const double exponent = -2.33 - 1.45 * (22 * std::pow(1e4, -1.0 / 3) - 1.17);
    EXPECT_NEAR(shape(2), 9.77 * std::pow(2, exponent), 1e-9);
}

TEST(Spreading, FollowsMitsuyasu) {
    const auto shape = [](double ratio) { return shapeAt(SpreadingModel::mitsuyasu, ratio); };
    const double atPeak = 11.5 * std::pow(22 * std::pow(1e4, -1.0 / 3), -2.5);
    EXPECT_NEAR(shape(1), atPeak, 1e-9);
    EXPECT_NEAR(shape(0.5), atPeak * std::pow(0.5, 5), 1e-9);
    EXPECT_NEAR(shape(2), atPeak * std::pow(2, -2.5), 1e-9);
}

TEST(Spreading, FollowsDonelanAndBanner) {
    const Spectrum spectrum = windSea();
    const auto spreadOf = [&](double ratio) {
        return spreadAt({.model = SpreadingModel::donelanBanner}, spectrum, ratio * spectrum.peak);
    };
    EXPECT_NEAR(spreadOf(0.8).beta, 2.61 * std::pow(0.8, 1.3), 1e-12);
    EXPECT_NEAR(spreadOf(1.2).beta, 2.28 * std::pow(1.2, -1.3), 1e-12);
    EXPECT_NEAR(spreadOf(3).beta, std::pow(10, -0.4 + 0.8393 * std::exp(-0.567 * std::log(9.0))), 1e-12);
    const double beta = spreadOf(1.2).beta;
    for (const double angle : {0.0, 0.7, 3.0}) {
        const double sech = 1 / std::cosh(beta * angle);
        EXPECT_NEAR(density(spreadOf(1.2), std::cos(angle)),
                    beta / (2 * std::tanh(beta * std::numbers::pi)) * sech * sech, 1e-12);
    }
}

TEST(Spreading, TakesTheShapeItIsGiven) {
    for (const double ratio : {0.5, 1.0, 3.0})
        EXPECT_EQ(shapeAt(SpreadingModel::cosine2s, ratio, 0, 12.5), 12.5);
}

TEST(Spreading, SwellElongatesLongWavesMost) {
    for (const auto model : {SpreadingModel::hasselmann, SpreadingModel::mitsuyasu,
                             SpreadingModel::donelanBanner, SpreadingModel::cosine2s}) {
        const auto gain = [&](double ratio, double swell) {
            return shapeAt(model, ratio, swell) - shapeAt(model, ratio, 0);
        };
        EXPECT_NEAR(gain(1, 1), 16 * std::tanh(1.0), 1e-9);
        EXPECT_NEAR(gain(1, 0.5), 4 * std::tanh(1.0), 1e-9);
        EXPECT_NEAR(gain(4, 1), 16 * std::tanh(0.25), 1e-9);
        EXPECT_GT(gain(0.5, 1), gain(2, 1));
        const Spectrum spectrum = windSea();
        const auto downwind = [&](double swell) {
            return density(spreadAt({.model = model, .shape = 3, .swell = swell}, spectrum, spectrum.peak),
                           1);
        };
        EXPECT_GT(downwind(1), downwind(0)) << static_cast<int>(model);
    }
}

TEST(Spreading, IsFiniteAgainstTheWind) {
    const auto power = [](double s, double cosine) {
        return density({.norm = spreadingNorm(s), .beta = 0, .shape = s}, cosine);
    };
    EXPECT_EQ(power(5, -1), 0);
    EXPECT_EQ(power(5, -1.0000001), 0);
    EXPECT_NEAR(power(0, -1), 0.5 / std::numbers::pi, 1e-9);
    EXPECT_TRUE(std::isfinite(density({.norm = 1, .beta = 2.4, .shape = 0}, -1.0000001)));
}

} // namespace
