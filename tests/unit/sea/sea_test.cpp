#include "seaglass/sea.h"

#include "tests/unit/sea/sea_support.h"
#include "water/spectrum/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace seaglass;
using tests::makeSea;
using tests::Maps;
using tests::moment;
using tests::Waves;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

struct Statistics {
    double variance = 0;
    double slopeVariance = 0;
};

Statistics ofMaps(const Sea& sea, uint32_t cascade, double time) {
    const Maps maps = Waves(sea).at(cascade, time);
    Statistics found;
    for (size_t t = 0; t < maps.texels(); ++t) {
        found.variance += maps.height(t) * maps.height(t);
        found.slopeVariance += maps.moments[4 * t] + maps.moments[4 * t + 1];
    }
    const auto count = static_cast<double>(maps.texels());
    return {found.variance / count, found.slopeVariance / count};
}

// The claim of this library: a sea of the spectrum's height, not one 2.8 times too high.
TEST(Sea, HasTheHeightOfItsSpectrum) {
    struct Case {
        SpectrumModel model;
        float wind, fetch, swell;
    };
    for (const Case& c :
         {Case{SpectrumModel::jonswap, 10, 300e3f, 0}, Case{SpectrumModel::jonswap, 15, 100e3f, 1},
          Case{SpectrumModel::jonswap, 2.5f, 1500, 0},
          Case{SpectrumModel::piersonMoskowitz, 10, 300e3f, 0}}) {
        SeaDesc desc;
        desc.spectrum = c.model;
        desc.windSpeed = c.wind;
        desc.fetch = c.fetch;
        desc.swell = c.swell;
        desc.samples = 128;
        constexpr uint64_t seeds = 16;
        double height = 0, slopes = 0;
        double bandHeight = 0, bandSlopeVariance = 0;
        for (uint64_t seed = 1; seed <= seeds; ++seed) {
            desc.seed = seed;
            const auto sea = makeSea(desc);
            double variance = 0;
            for (uint32_t i = 0; i < cascadeCount(*sea); ++i) {
                const Statistics found = ofMaps(*sea, i, 100);
                variance += found.variance;
                slopes += found.slopeVariance / seeds;
            }
            height += 4 * std::sqrt(variance) / seeds;
            const double kMax = cascade(*sea, cascadeCount(*sea) - 1).kMax;
            const Spectrum spectrum = makeSpectrum(desc);
            bandHeight = 4 * std::sqrt(moment(spectrum, 0, angularFrequency(kMax)));
            bandSlopeVariance = tests::slopeVariance(spectrum, kMax);
        }
        EXPECT_NEAR(height / bandHeight, 1, 0.02) << c.wind << " m/s over " << c.fetch << " m";
        // In less wind the spectrum's short waves are lowered: slope_variance_test.cpp.
        if (c.wind < 6) continue;
        EXPECT_NEAR(slopes / bandSlopeVariance, 1, 0.03) << c.wind << " m/s over " << c.fetch << " m";
    }
}

// Of the grids, whole and mean over seeds.
double simulatedHeight(SeaDesc desc) {
    constexpr uint64_t seeds = 16;
    double height = 0;
    for (desc.seed = 1; desc.seed <= seeds; ++desc.seed) {
        const auto sea = makeSea(desc);
        double variance = 0;
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) variance += ofMaps(*sea, c, 100).variance;
        height += 4 * std::sqrt(variance) / seeds;
    }
    return height;
}

TEST(Sea, SimulatesThePublishedHeights) {
    struct Row {
        SpectrumModel model;
        float wind, fetch, depth;
        double height;
    };
    constexpr auto pm = SpectrumModel::piersonMoskowitz;
    for (const Row& row :
         {Row{pm, 5, 1, infinity, 0.561}, Row{pm, 7.5f, 1, infinity, 1.263}, Row{pm, 10, 1, infinity, 2.245},
          Row{pm, 12.5f, 1, infinity, 3.508}, Row{pm, 15, 1, infinity, 5.052},
          Row{pm, 20, 1, infinity, 8.981}, Row{SpectrumModel::jonswap, 10, 10e3f, infinity, 0.594},
          Row{SpectrumModel::jonswap, 10, 100e3f, infinity, 2.139},
          Row{SpectrumModel::jonswap, 15, 100e3f, infinity, 3.064},
          Row{SpectrumModel::jonswap, 15, 300e3f, infinity, 5.647},
          Row{SpectrumModel::jonswap, 20, 300e3f, infinity, 7.288},
          Row{SpectrumModel::tma, 15, 300e3f, 5, 2.17}, Row{SpectrumModel::tma, 15, 300e3f, 10, 2.97},
          Row{SpectrumModel::tma, 15, 300e3f, 20, 3.95}, Row{SpectrumModel::tma, 15, 300e3f, 50, 5.20},
          Row{SpectrumModel::tma, 15, 300e3f, infinity, 5.65}}) {
        SeaDesc desc;
        desc.spectrum = row.model;
        desc.windSpeed = row.wind;
        desc.fetch = row.fetch;
        desc.depth = row.depth;
        desc.capFetch = false;
        desc.samples = 128;
        EXPECT_NEAR(simulatedHeight(desc) / row.height, 1, 0.03)
            << row.wind << " m/s over " << row.fetch << " m, " << row.depth << " m deep";
    }
}

TEST(Sea, SystemsAddTheirEnergies) {
    SeaDesc windSea;
    windSea.samples = 128;
    SeaDesc swell = windSea;
    swell.windSpeed = 0;
    swell.swells[0] = {.height = 1.5f, .peakPeriod = 11, .direction = 2};
    swell.swells[3] = {.height = 0.8f, .peakPeriod = 8, .direction = -1};
    SeaDesc both = swell;
    both.windSpeed = windSea.windSpeed;
    EXPECT_NEAR(simulatedHeight(swell), std::hypot(1.5, 0.8), 0.02 * 1.7);
    EXPECT_NEAR(simulatedHeight(both), std::hypot(simulatedHeight(windSea), 1.7), 0.02 * 2.7);
    EXPECT_NEAR(frequencySpectrum(*makeSea(both), 0.7),
                frequencySpectrum(*makeSea(windSea), 0.7) + frequencySpectrum(*makeSea(swell), 0.7), 1e-9);
}

TEST(Sea, SwellRunsWhereItIsSentTo) {
    SeaDesc desc;
    desc.windSpeed = 0;
    desc.samples = 64;
    desc.swells[0] = {.height = 2, .peakPeriod = 10, .direction = 2.5f};
    const auto sea = makeSea(desc);
    EXPECT_NEAR(peakFrequency(*sea), 2 * std::numbers::pi / 10, 1e-6);
    const Modes& modes = sea->modes[0];
    double east = 0, north = 0, all = 0;
    for (int32_t n = 0; n <= modes.reach; ++n) {
        for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
            const size_t at = modes.at(m, n);
            // forward runs towards -k, backward towards k.
            const double against = std::hypot(modes.forwardRe[at], modes.forwardIm[at]);
            const double along = std::hypot(modes.backwardRe[at], modes.backwardIm[at]);
            const double net = along * along - against * against;
            if (m == 0 && n == 0) continue;
            east += net * m / std::hypot(m, n);
            north += net * n / std::hypot(m, n);
            all += along * along + against * against;
        }
    }
    EXPECT_NEAR(std::atan2(north, east), 2.5, 0.1);
    EXPECT_GT(std::hypot(east, north) / all, 0.9) << "narrow";
}

TEST(Sea, IsTheTableThatItIsGiven) {
    std::vector<SpectrumSample> table = {{0.05f, 0}, {0.1f, 4}, {0.2f, 1}, {0.4f, 0}};
    SeaDesc desc;
    desc.spectrum = SpectrumModel::table;
    desc.spectrumTable = table.data();
    desc.spectrumTableCount = 4;
    desc.samples = 128;
    EXPECT_NEAR(simulatedHeight(desc) / (4 * std::sqrt(0.45)), 1, 0.02);
    const auto sea = makeSea(desc);
    table.assign(4, {});
    EXPECT_NEAR(frequencySpectrum(*sea, 0.2 * std::numbers::pi), 4 / (2 * std::numbers::pi), 1e-5)
        << "copied";
    EXPECT_EQ(description(*sea).spectrumTable[1].density, 4);
}

TEST(Sea, ShallowWaterSlowsItsWaves) {
    SeaDesc desc;
    desc.samples = 64;
    desc.depth = 3;
    const auto sea = makeSea(desc);
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
        const Modes& modes = sea->modes[c];
        for (int32_t n = 0; n <= modes.reach; ++n) {
            for (int32_t m = -modes.reach; m <= modes.reach; ++m) {
                const uint32_t found = modes.frequency[modes.at(m, n)];
                if (found == 0) continue;
                const double k = std::hypot(m, n) * 2 * std::numbers::pi / cascade(*sea, c).patch;
                const double omega = std::sqrt((9.81 * k + 7.4e-5 * k * k * k) * std::tanh(3 * k));
                EXPECT_NEAR(found, omega * desc.loopPeriod / (2 * std::numbers::pi), 0.51);
            }
        }
    }
    desc.depth = 0;
    EXPECT_EQ(cascadeCount(*makeSea(desc)), 0u) << "no water, no waves";
}

// A saved game, or a client of another version, must find the same sea: changing these values breaks both.
TEST(Sea, IsTheOneThatItsSeedHasAlwaysMeant) {
    SeaDesc desc;
    desc.windDirection = 0.4f;
    desc.choppiness = 0;
    desc.samples = 64;
    desc.seed = 20;
    desc.warp = 0;
    const auto sea = makeSea(desc);
    const double points[] = {0, 0, 31, -12};
    HeightSample samples[2];
    sampleHeights(*sea, 5, points, 2, samples);
    const double tolerance = 1e-4 * significantWaveHeight(*sea);
    EXPECT_NEAR(samples[0].height, 0.172902, tolerance);
    EXPECT_NEAR(samples[1].height, 0.903829, tolerance);
}

// World Meteorological Organization, probable heights of the open sea.
TEST(Sea, BeaufortsForcesHaveTheirHeights) {
    constexpr double probable[] = {0, 0.1, 0.2, 0.6, 1, 2, 3, 4, 5.5, 7, 9, 11.5, 14};
    constexpr float winds[] = {0, 0.8f, 2.4f, 4.3f, 6.7f, 9.3f, 12.3f, 15.5f, 18.9f, 23, 27, 31, 33};
    EXPECT_EQ(cascadeCount(*makeSea(beaufortSea(0))), 0u);
    for (uint32_t force = 1; force <= 12; ++force) {
        SeaDesc desc = beaufortSea(force, 2);
        EXPECT_EQ(desc.windSpeed, winds[force]);
        EXPECT_EQ(desc.windDirection, 2);
        desc.samples = 128;
        EXPECT_NEAR(simulatedHeight(desc) / probable[force], 1, 0.03) << force;
    }
    EXPECT_EQ(beaufortSea(99).windSpeed, beaufortSea(12).windSpeed);
}

// A month on, no frame repeats or jumps: each mode turns by its own angle from frame to frame.
TEST(Sea, RunsSmoothlyAfterAMonth) {
    SeaDesc desc;
    desc.samples = 64;
    const auto sea = makeSea(desc);
    Waves waves(*sea);
    const auto stepAt = [&](double time) {
        const Maps before = waves.at(0, time), after = waves.at(0, time + 1.0 / 60);
        double sum = 0;
        for (size_t t = 0; t < before.texels(); ++t) {
            const double step = after.height(t) - before.height(t);
            sum += step * step;
        }
        return std::sqrt(sum / static_cast<double>(before.texels()));
    };
    double usual = 0;
    constexpr int frames = 20;
    for (int i = 0; i < frames; ++i) usual += stepAt(i / 60.0) / frames;
    ASSERT_GT(usual, 0);
    for (int i = 0; i < frames; ++i)
        EXPECT_NEAR(stepAt(30 * 86400.0 + i / 60.0) / usual, 1, 0.3) << "frame " << i;
}

TEST(Sea, SpectrumHasThePublishedSlopes) {
    SeaDesc desc;
    desc.capFetch = false;
    const Spectrum spectrum = makeSpectrum(desc);
    // Cascades that resolved 1 m, 10 cm and 2 cm waves would hold so much.
    EXPECT_NEAR(tests::slopeVariance(spectrum, 6.28), 0.018, 1e-3);
    EXPECT_NEAR(tests::slopeVariance(spectrum, 62.8), 0.028, 1e-3);
    EXPECT_NEAR(tests::slopeVariance(spectrum, 314), 0.034, 1e-3);
}

TEST(Sea, TheMapsHaveTheResolvedSlopeVariance) {
    SeaDesc desc;
    desc.amplitude = 0.5f;
    const auto sea = makeSea(desc);
    Waves waves(*sea);
    double sum = 0;
    for (uint32_t c = 0; c < desc.cascades; ++c) {
        const Maps maps = waves.at(c, 12);
        double band = 0;
        for (size_t texel = 0; texel < maps.texels(); ++texel)
            band += static_cast<double>(maps.moments[4 * texel]) +
                    static_cast<double>(maps.moments[4 * texel + 1]);
        sum += band / static_cast<double>(maps.texels());
    }
    EXPECT_NEAR(sum, resolvedSlopeVariance(*sea), 0.03 * sum);
    desc.windSpeed = 0;
    EXPECT_EQ(resolvedSlopeVariance(*makeSea(desc)), 0);
}

TEST(Sea, CascadesHaveTheVarianceOfTheirBand) {
    SeaDesc desc;
    constexpr uint64_t seeds = 64;
    double variance[maxCascades] = {};
    Cascade bands[maxCascades];
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        desc.seed = seed;
        const auto sea = makeSea(desc);
        double total = 0;
        for (uint32_t c = 0; c < desc.cascades; ++c) {
            bands[c] = cascade(*sea, c);
            variance[c] += bands[c].variance / seeds;
            total += bands[c].variance;
        }
        EXPECT_DOUBLE_EQ(significantWaveHeight(*sea), 4 * std::sqrt(total));
    }
    const Spectrum spectrum = makeSpectrum(desc);
    for (uint32_t c = 0; c < desc.cascades; ++c) {
        const double expected =
            moment(spectrum, angularFrequency(bands[c].kMin), angularFrequency(bands[c].kMax));
        EXPECT_NEAR(variance[c] / expected, 1, 0.03) << c;
    }
}

TEST(Sea, SaysHowMuchOfItsSpectrumItHolds) {
    SeaDesc desc;
    EXPECT_NEAR(resolvedShare(*makeSea(desc)), 1, 0.02);
    SeaDesc sheltered = desc;
    sheltered.amplitude = 0.3f;
    sheltered.swells[0] = {.height = 1.5f, .peakPeriod = 11, .direction = 2};
    EXPECT_NEAR(resolvedShare(*makeSea(sheltered)), 1, 0.08)
        << "of a narrow swell the lattice holds few waves";
    desc.samples = 64;
    for (const float patch : {600.0f, 150.0f, 60.0f, 20.0f}) {
        desc.largestPatch = patch;
        double variance = 0;
        constexpr uint64_t seeds = 64;
        for (desc.seed = 1; desc.seed <= seeds; ++desc.seed)
            for (uint32_t c = 0; c < desc.cascades; ++c)
                variance += cascade(*makeSea(desc), c).variance / seeds;
        const auto sea = makeSea(desc);
        const double asked = moment(makeSpectrum(desc), 0, infinity);
        EXPECT_NEAR(variance / asked / resolvedShare(*sea), 1, 0.15) << patch; // few waves
    }
    EXPECT_LT(resolvedShare(*makeSea(desc)), 0.25);
    desc.windSpeed = 0;
    EXPECT_EQ(resolvedShare(*makeSea(desc)), 1) << "flat";
}

TEST(Sea, IsHigherInMoreWind) {
    SeaDesc desc;
    desc.samples = 64;
    double last = 0;
    for (const float wind : {2.0f, 4.0f, 8.0f, 16.0f, 32.0f, 60.0f, 100.0f}) {
        desc.windSpeed = wind;
        const double height = significantWaveHeight(*makeSea(desc));
        EXPECT_GT(height, last) << wind;
        last = height;
    }
}

TEST(Sea, AmplitudeScalesItsHeights) {
    SeaDesc desc;
    desc.samples = 64;
    const double full = significantWaveHeight(*makeSea(desc));
    desc.amplitude = 0.25f;
    EXPECT_NEAR(significantWaveHeight(*makeSea(desc)), full / 4, 1e-6 * full);
    desc.amplitude = 0;
    EXPECT_EQ(cascadeCount(*makeSea(desc)), 0u);
}

TEST(Sea, IsFlatWithoutWind) {
    SeaDesc desc;
    desc.windSpeed = 0;
    const auto sea = makeSea(desc);
    ASSERT_TRUE(sea);
    EXPECT_EQ(cascadeCount(*sea), 0u);
    EXPECT_EQ(peakFrequency(*sea), 0);
    EXPECT_EQ(significantWaveHeight(*sea), 0);
    EXPECT_EQ(sea->modes[0].forwardRe.capacity(), 0u);

    const double points[] = {0, 0, 1e6, -3};
    HeightSample samples[2];
    samples[1].height = 5;
    sampleHeights(*sea, 12, points, 2, samples);
    for (const HeightSample& sample : samples) {
        EXPECT_EQ(sample.height, 0);
        EXPECT_EQ(sample.normal[1], 1);
        EXPECT_EQ(sample.velocity[1], 0);
        EXPECT_EQ(sample.folded, 0u);
    }
}

bool allFinite(const std::vector<float>& values) {
    for (const float value : values)
        if (!std::isfinite(value)) return false;
    return true;
}

void expectFinite(const SeaDesc& desc, const std::string& what) {
    SeaError error;
    const tests::SeaPtr sea(createSea(&desc, &error), &destroySea);
    ASSERT_TRUE(sea) << what << ": " << error.text;
    EXPECT_TRUE(std::isfinite(significantWaveHeight(*sea))) << what;
    EXPECT_TRUE(std::isfinite(peakFrequency(*sea))) << what;
    EXPECT_TRUE(std::isfinite(resolvedSlopeVariance(*sea) + unresolvedSlopeVariance(*sea))) << what;
    Waves waves(*sea);
    for (const double time : {0.0, 1e9, -1e9}) {
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
            const Maps maps = waves.at(c, time);
            EXPECT_TRUE(allFinite(maps.displacement) && allFinite(maps.derivatives) &&
                        allFinite(maps.moments))
                << what;
        }
        const double points[] = {0.1, 0.2, 1e7, -1e7, 1e300, -1e300};
        HeightSample samples[3];
        sampleHeights(*sea, time, points, 3, samples);
        for (const HeightSample& s : samples) {
            EXPECT_TRUE(std::isfinite(s.height + s.normal[0] + s.normal[1] + s.normal[2] + s.velocity[0] +
                                      s.velocity[1] + s.velocity[2]))
                << what;
            EXPECT_NEAR(std::hypot(s.normal[0], s.normal[1], s.normal[2]), 1, 1e-5) << what;
        }
    }
}

TEST(Sea, IsFiniteAtItsExtremes) {
    for (const float wind : {1e-40f, 0.01f, 0.5f, 100.0f}) {
        for (const float fetch : {1.0f, 1e6f}) {
            for (const float choppiness : {0.0f, 10.0f}) {
                for (const float patch : {0.0f, 1.0f, 1e5f}) {
                    for (const double loop : {16.0, 1e6}) {
                        SeaDesc desc;
                        desc.windSpeed = wind;
                        desc.fetch = fetch;
                        desc.capFetch = false;
                        desc.choppiness = choppiness;
                        desc.largestPatch = patch;
                        desc.loopPeriod = loop;
                        desc.swell = 1;
                        desc.samples = 32;
                        desc.cascades = maxCascades;
                        expectFinite(desc, "wind " + std::to_string(wind) + " fetch " +
                                               std::to_string(fetch) + " choppiness " +
                                               std::to_string(choppiness) + " patch " +
                                               std::to_string(patch) + " loop " + std::to_string(loop));
                    }
                }
            }
        }
    }
}

TEST(Sea, EveryModelIsFiniteAtItsExtremes) {
    const SpectrumSample table[] = {{0.01f, 1e6f}, {50, 1e6f}};
    for (uint32_t model = 0; model < std::size(spectrumModels); ++model) {
        for (uint32_t spreading = 0; spreading < std::size(spreadingModels); ++spreading) {
            for (const float depth : {0.0f, 1e-40f, 1e-3f, 5.0f, 1e30f, infinity}) {
                for (const float wind : {0.0f, 1e-30f, 3.0f, 100.0f}) {
                    for (const float fetch : {1.0f, 1e6f}) {
                        SeaDesc desc;
                        desc.spectrum = static_cast<SpectrumModel>(model);
                        desc.spreading = static_cast<SpreadingModel>(spreading);
                        desc.spectrumTable = table;
                        desc.spectrumTableCount = 2;
                        desc.spreadingShape = 1000;
                        desc.depth = depth;
                        desc.windSpeed = wind;
                        desc.fetch = fetch;
                        desc.capFetch = false;
                        desc.choppiness = 10;
                        desc.samples = 16;
                        desc.swells[2] = {.height = 30, .peakPeriod = 30, .direction = 1, .spreading = 1000};
                        expectFinite(desc, "model " + std::to_string(model) + " spreading " +
                                               std::to_string(spreading) + " depth " + std::to_string(depth) +
                                               " wind " + std::to_string(wind) + " fetch " +
                                               std::to_string(fetch));
                    }
                }
            }
        }
    }
}

TEST(Sea, NamesTheFieldItRejects) {
    struct Case {
        const char* field;
        const char* value;
        const char* expected;
        std::function<void(SeaDesc&)> spoil;
    };
    const auto notANumber = static_cast<float>(nan);
    const Case cases[] = {
        {"spectrum", "7", "0", [](SeaDesc& d) { d.spectrum = static_cast<SpectrumModel>(7); }},
        {"windSpeed", "nan", "0 to 100", [&](SeaDesc& d) { d.windSpeed = notANumber; }},
        {"windSpeed", "-1", "0 to 100", [](SeaDesc& d) { d.windSpeed = -1; }},
        {"windSpeed", "101", "0 to 100", [](SeaDesc& d) { d.windSpeed = 101; }},
        {"windDirection", "nan", "finite", [&](SeaDesc& d) { d.windDirection = notANumber; }},
        {"windDirection", "inf", "finite",
         [](SeaDesc& d) { d.windDirection = std::numeric_limits<float>::infinity(); }},
        {"fetch", "0.5", "1 to 1e+06", [](SeaDesc& d) { d.fetch = 0.5f; }},
        {"fetch", "nan", "1 to 1e+06", [&](SeaDesc& d) { d.fetch = notANumber; }},
        {"fetch", "1100000", "1 to 1e+06", [](SeaDesc& d) { d.fetch = 1.1e6f; }},
        {"spreading", "4", "0 to 3", [](SeaDesc& d) { d.spreading = static_cast<SpreadingModel>(4); }},
        {"spreadingShape", "-1", "0 to 1000", [](SeaDesc& d) { d.spreadingShape = -1; }},
        {"spreadingShape", "nan", "0 to 1000", [&](SeaDesc& d) { d.spreadingShape = notANumber; }},
        {"depth", "-1", "0 to inf", [](SeaDesc& d) { d.depth = -1; }},
        {"depth", "nan", "0 to inf", [&](SeaDesc& d) { d.depth = notANumber; }},
        {"swells[1].height", "-1", "0 to 30 m", [](SeaDesc& d) { d.swells[1].height = -1; }},
        {"swells[3].height", "nan", "0 to 30 m", [&](SeaDesc& d) { d.swells[3].height = notANumber; }},
        {"swells[0].peakPeriod", "0", "1 to 30 s", [](SeaDesc& d) { d.swells[0].peakPeriod = 0; }},
        {"swells[0].direction", "inf", "finite", [](SeaDesc& d) { d.swells[0].direction = infinity; }},
        {"swells[0].bandwidth", "0.5", "0.02 to 0.25", [](SeaDesc& d) { d.swells[0].bandwidth = 0.5f; }},
        {"swells[0].spreading", "-2", "0 to 1000", [](SeaDesc& d) { d.swells[0].spreading = -2; }},
        {"peakEnhancement", "0", "1 to 10", [](SeaDesc& d) { d.peakEnhancement = 0; }},
        {"peakEnhancement", "nan", "1 to 10", [&](SeaDesc& d) { d.peakEnhancement = notANumber; }},
        {"amplitude", "1.5", "0 to 1", [](SeaDesc& d) { d.amplitude = 1.5f; }},
        {"amplitude", "nan", "0 to 1", [&](SeaDesc& d) { d.amplitude = notANumber; }},
        {"swell", "2", "0 to 1", [](SeaDesc& d) { d.swell = 2; }},
        {"swell", "nan", "0 to 1", [&](SeaDesc& d) { d.swell = notANumber; }},
        {"choppiness", "-1", "0 to 10", [](SeaDesc& d) { d.choppiness = -1; }},
        {"choppiness", "nan", "0 to 10", [&](SeaDesc& d) { d.choppiness = notANumber; }},
        {"samples", "8", "16 to 2048", [](SeaDesc& d) { d.samples = 8; }},
        {"samples", "4096", "16 to 2048", [](SeaDesc& d) { d.samples = 4096; }},
        {"samples", "100", "power of two", [](SeaDesc& d) { d.samples = 100; }},
        {"cascades", "0", "1 to 4", [](SeaDesc& d) { d.cascades = 0; }},
        {"cascades", "5", "1 to 4", [](SeaDesc& d) { d.cascades = 5; }},
        {"largestPatch", "0.5", "1 to 100000", [](SeaDesc& d) { d.largestPatch = 0.5f; }},
        {"largestPatch", "nan", "1 to 100000", [&](SeaDesc& d) { d.largestPatch = notANumber; }},
        {"largestPatch", "200000", "1 to 100000", [](SeaDesc& d) { d.largestPatch = 200000; }},
        {"warp", "1.5", "0 to 1", [](SeaDesc& d) { d.warp = 1.5f; }},
        {"loopPeriod", "0", "16 to 1e+06", [](SeaDesc& d) { d.loopPeriod = 0; }},
        {"loopPeriod", "nan", "16 to 1e+06", [](SeaDesc& d) { d.loopPeriod = nan; }},
    };
    for (const Case& c : cases) {
        SeaDesc desc;
        c.spoil(desc);
        SeaError error;
        const tests::SeaPtr sea(createSea(&desc, &error), &destroySea);
        EXPECT_FALSE(sea) << c.field << " = " << c.value;
        const std::string text = error.text;
        EXPECT_NE(text.find(std::string("SeaDesc.") + c.field + " is " + c.value), std::string::npos) << text;
        EXPECT_NE(text.find(c.expected), std::string::npos) << text;
        EXPECT_EQ(createSea(&desc, nullptr), nullptr) << "without an error to fill";
    }
}

TEST(Sea, NamesWhatItRejectsOfATable) {
    struct Case {
        std::vector<SpectrumSample> samples;
        const char* expected;
    };
    const Case cases[] = {
        {{}, "SeaDesc.spectrumTable is null"},
        {{{0.1f, 1}}, "SeaDesc.spectrumTableCount is 1; expected 2 to 4096"},
        {{{0, 1}, {0.2f, 1}}, "SeaDesc.spectrumTable[0].frequency is 0; expected 0.01 to 50 Hz"},
        {{{0.125f, 1}, {0.25f, -1}}, "SeaDesc.spectrumTable[1].density is -1; expected 0 to 1e+06"},
        {{{0.125f, 1}, {0.25f, infinity}}, "SeaDesc.spectrumTable[1].density is inf"},
        {{{0.5f, 1}, {0.25f, 1}}, "SeaDesc.spectrumTable[1].frequency is 0.25; expected more than 0.5"},
        {{{0.125f, 0}, {0.25f, 0}}, "SeaDesc.spectrumTable has no density above 0"},
    };
    for (const Case& c : cases) {
        SeaDesc desc;
        desc.spectrum = SpectrumModel::table;
        desc.spectrumTable = c.samples.empty() ? nullptr : c.samples.data();
        desc.spectrumTableCount = static_cast<uint32_t>(c.samples.size());
        SeaError error;
        EXPECT_EQ(createSea(&desc, &error), nullptr);
        EXPECT_NE(std::string(error.text).find(c.expected), std::string::npos) << error.text;
    }
    SeaDesc other;
    other.spectrumTableCount = 7;
    EXPECT_TRUE(makeSea(other)) << "a table that is not asked for is not read";
}

TEST(Sea, LeavesTheErrorEmptyWhenAllIsWell) {
    SeaError error;
    error.text[0] = 'x';
    const SeaDesc desc;
    const tests::SeaPtr sea(createSea(&desc, &error), &destroySea);
    EXPECT_TRUE(sea);
    EXPECT_STREQ(error.text, "");
    EXPECT_EQ(createSea(nullptr, &error), nullptr);
    EXPECT_STRNE(error.text, "");
    destroySea(nullptr);
}

} // namespace
