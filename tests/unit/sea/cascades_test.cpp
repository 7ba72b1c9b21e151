#include "water/sea/cascades.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace {

using namespace seaglass;
using tests::makeSea;

constexpr double tau = 2 * std::numbers::pi;

SeaDesc withSamples(uint32_t samples) {
    SeaDesc desc;
    desc.samples = samples;
    desc.cascades = maxCascades;
    return desc;
}

TEST(Cascades, BandsTouchAndAreSampledFourTimesAWave) {
    for (const uint32_t samples : {16u, 64u, 128u, 256u, 1024u}) {
        const auto sea = makeSea(withSamples(samples));
        const Cascade& last = cascade(*sea, cascadeCount(*sea) - 1);
        EXPECT_NEAR(last.kMax * last.patch / tau, samples / 4, 1e-9) << samples;
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
            const Cascade& band = cascade(*sea, c);
            EXPECT_LE(band.kMax, tau / band.patch * samples / 4 * (1 + 1e-12)) << samples << ", " << c;
            EXPECT_EQ(band.kMin, c == 0 ? 0 : cascade(*sea, c - 1).kMax) << samples << ", " << c;
            EXPECT_GE(band.kMax, band.kMin) << samples << ", " << c;
        }
    }
}

TEST(Cascades, LongestWavesRepeatOftenOnTheirTile) {
    const auto sea = makeSea(withSamples(256));
    for (uint32_t c = 1; c < cascadeCount(*sea); ++c)
        EXPECT_GE(cascade(*sea, c).kMin * cascade(*sea, c).patch / tau, 8);
    EXPECT_GE(peakWavelength(makeSpectrum(description(*sea))) * 10, cascade(*sea, 0).patch / 2);
}

TEST(Cascades, EndAtAMillimetre) {
    SeaDesc desc = withSamples(512);
    desc.largestPatch = 1;
    const auto sea = makeSea(desc);
    const Cascade& last = cascade(*sea, maxCascades - 1);
    EXPECT_EQ(last.kMax, tau / 1e-3);
    EXPECT_GE(last.kMax, last.kMin);
}

TEST(Cascades, TilesLineUpNowhereNear) {
    const auto sea = makeSea(withSamples(256));
    for (uint32_t c = 1; c < cascadeCount(*sea); ++c) {
        const double ratio = cascade(*sea, 0).patch / cascade(*sea, c).patch;
        for (int tiles = 1; tiles <= 5; ++tiles) {
            const double off = tiles * ratio - std::round(tiles * ratio);
            EXPECT_GT(std::abs(off), 1e-3) << tiles << " of tile 0 on tiles " << c;
        }
    }
}

TEST(Cascades, LargestPatchIsAsAskedOrFitsThePeak) {
    SeaDesc desc;
    desc.largestPatch = 333;
    EXPECT_EQ(cascade(*makeSea(desc), 0).patch, 333);
    desc.largestPatch = 0;
    EXPECT_NEAR(cascade(*makeSea(desc), 0).patch, 16 * peakWavelength(makeSpectrum(desc)), 1e-6);
    desc.windSpeed = 1;
    EXPECT_EQ(cascade(*makeSea(desc), 0).patch, 60);
    desc.windSpeed = 40;
    EXPECT_EQ(cascade(*makeSea(desc), 0).patch, 2000);
    desc.spectrum = SpectrumModel::piersonMoskowitz;
    EXPECT_NEAR(cascade(*makeSea(desc), 0).patch, 6 * peakWavelength(makeSpectrum(desc)), 1e-6);
    SeaDesc swell;
    swell.depth = 4;
    swell.swells[0] = {.height = 1, .peakPeriod = 14};
    EXPECT_NEAR(cascade(*makeSea(swell), 0).patch, 16 * peakWavelength(makeSpectrum(swell.swells[0]), 4),
                1e-6)
        << "of the longest system, over its depth";
}

TEST(Cascades, ModesKeepToTheirBand) {
    const auto sea = makeSea(withSamples(64));
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
        const Cascade& band = cascade(*sea, c);
        const Modes& modes = sea->modes[c];
        EXPECT_LT(modes.reach, 64 / 2) << "the Nyquist row and column stay empty";
        size_t held = 0;
        for (int32_t n = 0; n <= modes.reach; ++n) {
            for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
                const double k = std::hypot(m, n) * tau / band.patch;
                const size_t at = modes.at(m, n);
                const bool inBand = k >= band.kMin && k < band.kMax;
                const bool half = n > 0 || m > 0;
                EXPECT_EQ(modes.frequency[at] != 0, inBand && half) << m << ", " << n;
                if (inBand && half)
                    ++held;
                else
                    EXPECT_EQ(std::abs(modes.forwardRe[at]) + std::abs(modes.backwardIm[at]), 0)
                        << m << ", " << n;
            }
        }
        EXPECT_GT(held, 100u) << c;
    }
}

void expectTruncation(SeaDesc desc, uint32_t samples) {
    desc.samples = samples;
    const auto coarse = makeSea(desc);
    desc.samples = 2 * samples;
    const auto fine = makeSea(desc);
    for (uint32_t c = 0; c < cascadeCount(*coarse); ++c) {
        const Modes &few = coarse->modes[c], &many = fine->modes[c];
        ASSERT_EQ(cascade(*coarse, c).patch, cascade(*fine, c).patch);
        size_t shared = 0, lost = 0;
        for (int32_t n = 0; n <= few.reach; ++n) {
            for (int32_t m = -few.reach; m <= few.reach; ++m) {
                const size_t a = few.at(m, n), b = many.at(m, n);
                if (few.frequency[a] == 0) continue;
                if (many.frequency[b] == 0) {
                    ++lost;
                    continue;
                }
                ++shared;
                EXPECT_EQ(few.frequency[a], many.frequency[b]);
                EXPECT_EQ(few.forwardRe[a], many.forwardRe[b]);
                EXPECT_EQ(few.forwardIm[a], many.forwardIm[b]);
                EXPECT_EQ(few.backwardRe[a], many.backwardRe[b]);
                EXPECT_EQ(few.backwardIm[a], many.backwardIm[b]);
            }
        }
        EXPECT_GT(shared, 100u);
        if (samples >= 256) {
            EXPECT_EQ(lost, 0u) << "cascade " << c;
        }
    }
}

TEST(Cascades, SharedModesAreTheSameWhenSamplesDouble) {
    const SpectrumSample table[] = {{0.05f, 0}, {0.1f, 4}, {0.2f, 1}, {0.4f, 0}};
    for (uint32_t model = 0; model < std::size(spectrumModels); ++model) {
        SeaDesc desc = withSamples(64);
        desc.spectrum = static_cast<SpectrumModel>(model);
        desc.depth = 20;
        desc.spectrumTable = table;
        desc.spectrumTableCount = 4;
        desc.swells[0] = {.height = 1, .peakPeriod = 9, .direction = 1};
        for (const uint32_t samples : {64u, 256u}) expectTruncation(desc, samples);
    }
    for (const auto spreading :
         {SpreadingModel::mitsuyasu, SpreadingModel::donelanBanner, SpreadingModel::cosine2s}) {
        SeaDesc desc = withSamples(64);
        desc.spreading = spreading;
        desc.swell = 0.3f;
        expectTruncation(desc, 64);
    }
}

// However few the samples: a sea is never flat by accident.
TEST(Cascades, HoldEveryPeak) {
    struct Case {
        float wind;
        double swellPeriod;
    };
    for (const Case c : {Case{0.5f, 0}, Case{3, 0}, Case{10, 0}, Case{30, 0}, Case{100, 0}, Case{5, 20}}) {
        for (const uint32_t samples : {16u, 64u, 256u}) {
            for (uint32_t cascades = 1; cascades <= maxCascades; ++cascades) {
                SeaDesc desc = withSamples(samples);
                desc.cascades = cascades;
                desc.windSpeed = c.wind;
                desc.spectrum = SpectrumModel::piersonMoskowitz;
                if (c.swellPeriod > 0)
                    desc.swells[0] = {.height = 2, .peakPeriod = static_cast<float>(c.swellPeriod)};
                double height = 0;
                for (desc.seed = 1; desc.seed <= 8; ++desc.seed)
                    height += significantWaveHeight(*makeSea(desc)) / 8;
                const double wind195 = 1.026 * static_cast<double>(c.wind);
                const double windSea = 0.21 * wind195 * wind195 / 9.81;
                const double whole = std::hypot(windSea, c.swellPeriod > 0 ? 2 : 0);
                EXPECT_GT(height, 0.55 * whole) << c.wind << " m/s, " << samples << " x " << cascades;
                // A narrow peak on the first waves of a lattice is that much louder.
                EXPECT_LT(height, (samples > 16 ? 1.1 : 1.5) * whole)
                    << c.wind << " m/s, " << samples << " x " << cascades;
            }
        }
    }
}

TEST(Cascades, SeedsAndCascadesDiffer) {
    SeaDesc desc = withSamples(64);
    const auto first = makeSea(desc);
    desc.seed = 2;
    const auto second = makeSea(desc);
    EXPECT_NE(first->modes[0].forwardRe, second->modes[0].forwardRe);
    const auto amplitude = [&](size_t c) {
        const size_t at = first->modes[c].at(9, 9);
        return std::complex<double>(first->modes[c].forwardRe[at], first->modes[c].forwardIm[at]);
    };
    EXPECT_GT(std::abs(std::arg(amplitude(2) / amplitude(3))), 1e-3) << "the same variates in two cascades";
}

} // namespace
