#include "water/spreading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace seaglass;

Spectrum windSea() {
    return makeSpectrum(SeaDesc{});
}

TEST(Spreading, NormMatchesPublishedValues) {
    EXPECT_NEAR(spreadingNorm(0), 0.5 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(spreadingNorm(1), 0.31831, 5e-6);
    EXPECT_NEAR(spreadingNorm(5), 0.64672, 5e-6);
    EXPECT_NEAR(spreadingNorm(16), 1.13723, 5e-6);
}

TEST(Spreading, IntegratesToOne) {
    for (const double shape : {0.0, 1e-3, 0.3, 1.0, 7.0, 16.0, 30.9, 31.0, 33.0, 200.0, 1e5}) {
        constexpr int steps = 200000;
        const double step = 2 * std::numbers::pi / steps;
        double sum = 0;
        for (int i = 0; i < steps; ++i) sum += spreading(shape, std::cos(i * step)) * step;
        EXPECT_NEAR(sum, 1, 1e-5) << "s = " << shape;
    }
}

TEST(Spreading, FollowsHasselmann) {
    const Spectrum spectrum = windSea();
    const double p = spectrum.peak;
    EXPECT_NEAR(spreadingShape(spectrum, p, 0), 6.97, 1e-9);
    EXPECT_NEAR(spreadingShape(spectrum, 0.5 * p, 0), 6.97 * std::pow(0.5, 4.06), 1e-9);
    // U wp / g = 22 chi^(-1/3), and chi is held at 1e4.
    const double exponent = -2.33 - 1.45 * (22 * std::pow(1e4, -1.0 / 3) - 1.17);
    EXPECT_NEAR(spreadingShape(spectrum, 2 * p, 0), 9.77 * std::pow(2, exponent), 1e-9);
}

TEST(Spreading, SwellElongatesLongWavesMost) {
    const Spectrum spectrum = windSea();
    const double p = spectrum.peak;
    const auto gain = [&](double omega, double swell) {
        return spreadingShape(spectrum, omega, swell) - spreadingShape(spectrum, omega, 0);
    };
    EXPECT_NEAR(gain(p, 1), 16 * std::tanh(1.0), 1e-9);
    EXPECT_NEAR(gain(p, 0.5), 4 * std::tanh(1.0), 1e-9);
    EXPECT_NEAR(gain(4 * p, 1), 16 * std::tanh(0.25), 1e-9);
    EXPECT_GT(gain(p / 2, 1), gain(2 * p, 1));
}

TEST(Spreading, IsFiniteAgainstTheWind) {
    EXPECT_EQ(spreading(5, -1), 0);
    EXPECT_EQ(spreading(5, -1.0000001), 0);
    EXPECT_NEAR(spreading(0, -1), 0.5 / std::numbers::pi, 1e-9);
}

} // namespace
