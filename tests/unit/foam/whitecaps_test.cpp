#include "water/interface/whitecaps.h"

#include "gpu/field_error.h"
#include "tests/unit/sea/sea_support.h"
#include "water/foam/foam_history.h"
#include "water/interface/fields/sea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace seaglass;
using tests::makeSea;

SeaDesc windSea(SpectrumModel spectrum, float wind, uint64_t seed) {
    SeaDesc desc;
    desc.spectrum = spectrum;
    desc.windSpeed = wind;
    desc.cascades = 2; // the third is too short to foam
    desc.seed = seed;
    return desc;
}

double coverOf(const SeaDesc& desc, const FoamDesc& foam = {}, double time = 100.3) {
    const auto sea = makeSea(desc);
    double cover = -1;
    EXPECT_TRUE(whitecapCover(*sea, tests::builtBackend(), foam, time, &cover));
    return cover;
}

TEST(Whitecaps, LawsGiveTheirPublishedValues) {
    EXPECT_NEAR(whitecapsOfMonahan(5), 9.3e-4, 0.1e-4);
    EXPECT_NEAR(whitecapsOfMonahan(10), 9.9e-3, 0.1e-3);
    EXPECT_NEAR(whitecapsOfMonahan(15), 0.039, 1e-3);
    EXPECT_NEAR(whitecapsOfMonahan(20), 0.105, 1e-3);
    EXPECT_EQ(whitecapsOfMonahan(0), 0);
    EXPECT_NEAR(whitecapsOfCallaghan(8), 3.18e-5 * std::pow(4.3, 3), 1e-9);
    EXPECT_NEAR(whitecapsOfCallaghan(20), 4.82e-6 * std::pow(21.98, 3), 1e-9);
    EXPECT_NEAR(whitecapsOfCallaghan(10.1869), whitecapsOfCallaghan(10.1871), 1e-5);
    EXPECT_EQ(whitecapsOfCallaghan(3), 0);
}

TEST(Whitecaps, CoverLiesBetweenTheLaws) {
    constexpr int seeds = 2;
    constexpr double widened = 1.5;
    for (const SpectrumModel spectrum : {SpectrumModel::jonswap, SpectrumModel::piersonMoskowitz})
        for (const float wind : {8.0f, 10.0f, 12.0f, 15.0f, 20.0f}) {
            double cover = 0;
            for (uint64_t seed = 1; seed <= seeds; ++seed)
                cover += coverOf(windSea(spectrum, wind, seed)) / seeds;
            const double monahan = whitecapsOfMonahan(wind), callaghan = whitecapsOfCallaghan(wind);
            std::printf("%s %2.0f m/s: %.4f (Monahan %.4f, Callaghan %.4f)\n",
                        spectrum == SpectrumModel::jonswap ? "JONSWAP" : "PM", static_cast<double>(wind),
                        cover, monahan, callaghan);
            EXPECT_GT(cover, std::min(monahan, callaghan) / widened);
            EXPECT_LT(cover, std::max(monahan, callaghan) * widened);
        }
}

TEST(Whitecaps, ShelteredAndRoundWavesFoamLessAndABiasMore) {
    SeaDesc desc = windSea(SpectrumModel::jonswap, 12, 1);
    desc.samples = 128;
    const double open = coverOf(desc);
    EXPECT_GT(coverOf(desc, {.bias = 0.05f}), 1.5 * open);
    EXPECT_LT(coverOf(desc, {.bias = -0.05f}), 0.7 * open);
    desc.amplitude = 0.5f;
    EXPECT_LT(coverOf(desc), 0.05 * open);
    desc.amplitude = 1;
    desc.choppiness = 0;
    EXPECT_EQ(coverOf(desc), 0);
}

TEST(Whitecaps, NothingBreaksInACalmOrALightBreeze) {
    SeaDesc desc = windSea(SpectrumModel::jonswap, 0, 1);
    EXPECT_EQ(coverOf(desc), 0);
    desc.windSpeed = 1.5f;
    EXPECT_EQ(breakingOf(*makeSea(desc), {}).count, 0u);
    EXPECT_EQ(coverOf(desc), 0);
}

TEST(Whitecaps, CrestsRunAsFastAsTheWavesWhoseSlopesTheyAre) {
    SeaDesc desc = windSea(SpectrumModel::jonswap, 12, 4);
    desc.windDirection = 0.7f;
    const auto sea = makeSea(desc);
    const Breaking breaking = breakingOf(*sea, {});
    ASSERT_GT(breaking.count, 0u);
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const Modes& modes = sea->modes[c];
        double slopes = 0, speeds = 0;
        for (size_t at = 0; at < modes.frequency.size(); ++at) {
            if (!(modes.inverseK[at] > 0)) continue;
            const double k = 1 / static_cast<double>(modes.inverseK[at]);
            const double frequency = 2 * std::numbers::pi * modes.frequency[at] / desc.loopPeriod;
            const double slope = k * k * varianceAt(modes, at);
            slopes += slope;
            speeds += slope * frequency / k;
        }
        const double speed = speeds / slopes;
        EXPECT_NEAR(breaking.runs[c][0], speed * std::cos(0.7), 1e-3 * speed) << c;
        EXPECT_NEAR(breaking.runs[c][1], speed * std::sin(0.7), 1e-3 * speed) << c;
    }
}

TEST(Whitecaps, LateBreakersAreNarrowedNoMoreThanAlmostWhole) {
    SeaDesc steep = windSea(SpectrumModel::jonswap, 12, 4);
    steep.choppiness = 6;
    const auto sea = makeSea(steep);
    FoamDesc late;
    late.bias = -1;
    const Breaking usual = breakingOf(*sea, {}), most = breakingOf(*sea, late);
    ASSERT_GT(usual.now, 0.0f);
    ASSERT_LT(usual.now, 0.9f);
    ASSERT_GT(most.now, 1.0f);
    EXPECT_NEAR(most.narrower / usual.narrower, 0.9f / usual.now, 1e-3f);
}

TEST(Whitecaps, WavesThatAreTooLowForItKeepNoHistory) {
    SeaDesc desc = windSea(SpectrumModel::jonswap, 6, 1);
    EXPECT_GT(breakingOf(*makeSea(desc), {}).count, 0u);
    desc.amplitude = 0.3f;
    const auto low = makeSea(desc);
    EXPECT_EQ(breakingOf(*low, {}).count, 0u);
    EXPECT_GT(breakingOf(*low, {.bias = 0.3f}).count, 0u);
}

TEST(Whitecaps, RipplesAloneDoNotFoam) {
    SeaDesc desc;
    desc.cascades = 4;
    const auto sea = makeSea(desc);
    const Breaking breaking = breakingOf(*sea, {});
    EXPECT_EQ(breaking.count, 2u);
}

TEST(Whitecaps, BadFieldsAreNamed) {
    const auto refused = [](const FoamDesc& foam, const char* field) {
        const Field* bad = outOfRange(foamFields, &foam);
        double cover = -1;
        const auto sea = makeSea(tests::oneCascade());
        EXPECT_FALSE(whitecapCover(*sea, tests::builtBackend(), foam, 0, &cover)) << field;
        return bad && bad->name == std::string(field);
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const FoamDesc asNew;
    EXPECT_FALSE(outOfRange(foamFields, &asNew));
    EXPECT_TRUE(refused({.bias = nan}, "bias"));
    EXPECT_TRUE(refused({.bias = 2}, "bias"));
    EXPECT_TRUE(refused({.decayTime = 0}, "decayTime"));
    EXPECT_TRUE(refused({.decayTime = nan}, "decayTime"));
    EXPECT_TRUE(refused({.albedo = 1.1f}, "albedo"));
}

} // namespace
