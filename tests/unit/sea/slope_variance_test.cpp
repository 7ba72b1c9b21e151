#include "water/spectrum/slope_variance.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace seaglass;
using tests::makeSea;

double published(double wind) {
    return 0.003 + 5.12e-3 * wind;
}

/// Of the simulated maps, mean over cascades' texels.
SlopeCovariance measured(const Sea& sea) {
    tests::Waves waves(sea);
    SlopeCovariance sum;
    for (uint32_t c = 0; c < cascadeCount(sea); ++c) {
        const tests::Maps maps = waves.at(c, 30);
        const auto texels = static_cast<double>(maps.texels());
        for (size_t i = 0; i < maps.texels(); ++i) {
            sum.uu += static_cast<double>(maps.moments[4 * i]) / texels;
            sum.vv += static_cast<double>(maps.moments[4 * i + 1]) / texels;
            sum.uv += static_cast<double>(maps.moments[4 * i + 2]) / texels;
        }
    }
    return sum;
}

TEST(SlopeVariance, SimulatedAndRoughnessTogetherAreCoxAndMunks) {
    for (const SpectrumModel model : {SpectrumModel::jonswap, SpectrumModel::piersonMoskowitz})
        for (const uint32_t cascades : {2u, 3u, 4u})
            for (const float wind : {3.0f, 5.0f, 10.0f, 15.0f}) {
                SeaDesc desc;
                desc.spectrum = model;
                desc.windSpeed = wind;
                desc.cascades = cascades;
                desc.samples = 128;
                const auto sea = makeSea(desc);
                const SlopeCovariance found = measured(*sea);
                const double total = found.uu + found.vv + unresolvedSlopeVariance(*sea);
                std::printf(
                    "%2.0f m/s, %u cascades: simulated %.4f, roughness %.4f, total %.4f, Cox and Munk %.4f\n",
                    static_cast<double>(wind), cascades, found.uu + found.vv, unresolvedSlopeVariance(*sea),
                    total, published(wind));
                EXPECT_NEAR(total / published(wind), 1, 0.1) << wind << " m/s, " << cascades << " cascades";
                EXPECT_NEAR(coxMunkSlopeVariance(static_cast<double>(wind)) / published(wind), 1, 0.01);
            }
}

TEST(SlopeVariance, WhatIsSaidToBeResolvedIsSimulated) {
    SeaDesc desc;
    desc.windDirection = 0.6f;
    desc.samples = 128;
    const auto sea = makeSea(desc);
    const SlopeCovariance said = resolvedSlopes(*sea), found = measured(*sea);
    const double most = found.uu + found.vv;
    EXPECT_NEAR(said.uu, found.uu, 0.02 * most);
    EXPECT_NEAR(said.vv, found.vv, 0.02 * most);
    EXPECT_NEAR(said.uv, found.uv, 0.02 * most);
    EXPECT_GT(std::abs(said.uv), 0.05 * most);
}

TEST(SlopeVariance, YoungSeasAndGreatSampleCountsKeepTheBudget) {
    for (const float fetch : {1e3f, 10e3f, 300e3f})
        for (const uint32_t samples : {64u, 512u}) {
            SeaDesc desc;
            desc.fetch = fetch;
            desc.samples = samples;
            const auto sea = makeSea(desc);
            const double total = resolvedSlopeVariance(*sea) + unresolvedSlopeVariance(*sea);
            EXPECT_NEAR(total / published(10), 1, 0.1) << fetch << " m, " << samples << " samples";
        }
}

TEST(SlopeVariance, RoughnessIsGreaterAlongTheWindAndTurnsWithIt) {
    SeaDesc desc;
    const auto along = roughness(*makeSea(desc));
    EXPECT_GT(along.uu, 1.2 * along.vv);
    EXPECT_NEAR(along.uv, 0, 1e-9);
    desc.windDirection = static_cast<float>(std::numbers::pi / 2);
    const auto across = roughness(*makeSea(desc));
    EXPECT_NEAR(across.vv, along.uu, 0.1 * along.uu);
    EXPECT_NEAR(across.uu, along.vv, 0.1 * along.vv);
    desc.windDirection = static_cast<float>(std::numbers::pi / 4);
    const auto between = roughness(*makeSea(desc));
    EXPECT_NEAR(between.uv, (along.uu - along.vv) / 2, 0.1 * along.uu);
}

TEST(SlopeVariance, SheltersAndCalmsAreSmooth) {
    SeaDesc desc;
    desc.samples = 64;
    const double open = unresolvedSlopeVariance(*makeSea(desc));
    desc.amplitude = 0.5f;
    EXPECT_NEAR(unresolvedSlopeVariance(*makeSea(desc)), open / 4, 1e-4);
    desc.windSpeed = 0;
    EXPECT_EQ(unresolvedSlopeVariance(*makeSea(desc)), 0);
    EXPECT_EQ(coxMunkSlopeVariance(0), 0);
}

// A quality level is a truncation: what is lowered does not depend on what is resolved.
TEST(SlopeVariance, LoweredWavesAreTheSameAtAnyQuality) {
    SeaDesc desc;
    desc.windSpeed = 3;
    desc.samples = 512;
    const auto fine = makeSea(desc);
    desc.samples = 256;
    const auto coarse = makeSea(desc);
    for (uint32_t c = 0; c < desc.cascades; ++c) {
        const Modes &a = fine->modes[c], &b = coarse->modes[c];
        for (int32_t m = 1; m <= b.reach; ++m)
            EXPECT_EQ(a.forwardRe[a.at(m, 1)], b.forwardRe[b.at(m, 1)]) << c << ": " << m;
    }
    EXPECT_NEAR(significantWaveHeight(*fine) / significantWaveHeight(*coarse), 1, 1e-3);
}

} // namespace
