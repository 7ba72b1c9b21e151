#include "seaglass/sea.h"

#include "tests/unit/sea_support.h"
#include "water/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace {

using namespace seaglass;
using tests::makeSea;
using tests::Maps;
using tests::moment;
using tests::Waves;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
        EXPECT_NEAR(slopes / bandSlopeVariance, 1, 0.03) << c.wind << " m/s over " << c.fetch << " m";
    }
}

TEST(Sea, KnowsTheSlopesThatItsCascadesLeaveOut) {
    SeaDesc desc;
    desc.capFetch = false;
    const auto sea = makeSea(desc);
    const Spectrum spectrum = makeSpectrum(desc);
    // Cascades that resolved 1 m, 10 cm and 2 cm waves would hold so much, by the spectrum.
    EXPECT_NEAR(tests::slopeVariance(spectrum, 6.28), 0.018, 1e-3);
    EXPECT_NEAR(tests::slopeVariance(spectrum, 62.8), 0.028, 1e-3);
    EXPECT_NEAR(tests::slopeVariance(spectrum, 314), 0.034, 1e-3);
    constexpr double shortest = 365; // [rad/m], 17 mm
    const double resolved = tests::slopeVariance(spectrum, cascade(*sea, desc.cascades - 1).kMax);
    const double total = tests::slopeVariance(spectrum, shortest);
    EXPECT_NEAR(unresolvedSlopeVariance(*sea), total - resolved, 1e-3 * total);

    desc.amplitude = 0.5f;
    EXPECT_NEAR(unresolvedSlopeVariance(*makeSea(desc)), (total - resolved) / 4, 1e-3 * total);
    desc.windSpeed = 0;
    EXPECT_EQ(unresolvedSlopeVariance(*makeSea(desc)), 0);
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

TEST(Sea, IsHigherInMoreWind) {
    SeaDesc desc;
    desc.samples = 64;
    double last = 0;
    for (const float wind : {2.0f, 4.0f, 8.0f, 16.0f, 32.0f, 60.0f}) {
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
    void* waves = fftwWaves()->create(*sea);
    EXPECT_NE(waves, nullptr);
    fftwWaves()->destroy(waves);
}

bool allFinite(const std::vector<float>& values) {
    for (const float value : values)
        if (!std::isfinite(value)) return false;
    return true;
}

TEST(Sea, IsFiniteAtItsExtremes) {
    for (const float wind : {0.01f, 0.5f, 60.0f}) {
        for (const float fetch : {1.0f, 1e7f}) {
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
                        const auto sea = makeSea(desc);
                        ASSERT_TRUE(sea);
                        const std::string what = "wind " + std::to_string(wind) + " fetch " +
                                                 std::to_string(fetch) + " choppiness " +
                                                 std::to_string(choppiness) + " patch " +
                                                 std::to_string(patch) + " loop " + std::to_string(loop);
                        EXPECT_TRUE(std::isfinite(significantWaveHeight(*sea))) << what;
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
                                EXPECT_TRUE(std::isfinite(s.height + s.normal[0] + s.normal[1] + s.normal[2] +
                                                          s.velocity[0] + s.velocity[1] + s.velocity[2]))
                                    << what;
                                EXPECT_NEAR(std::hypot(s.normal[0], s.normal[1], s.normal[2]), 1, 1e-5)
                                    << what;
                            }
                        }
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
        {"windSpeed", "nan", "0 to 60", [&](SeaDesc& d) { d.windSpeed = notANumber; }},
        {"windSpeed", "-1", "0 to 60", [](SeaDesc& d) { d.windSpeed = -1; }},
        {"windSpeed", "61", "0 to 60", [](SeaDesc& d) { d.windSpeed = 61; }},
        {"windDirection", "nan", "finite", [&](SeaDesc& d) { d.windDirection = notANumber; }},
        {"windDirection", "inf", "finite",
         [](SeaDesc& d) { d.windDirection = std::numeric_limits<float>::infinity(); }},
        {"fetch", "0.5", "1 to 1e+07", [](SeaDesc& d) { d.fetch = 0.5f; }},
        {"fetch", "nan", "1 to 1e+07", [&](SeaDesc& d) { d.fetch = notANumber; }},
        {"peakEnhancement", "0", "1 to 10", [](SeaDesc& d) { d.peakEnhancement = 0; }},
        {"peakEnhancement", "nan", "1 to 10", [&](SeaDesc& d) { d.peakEnhancement = notANumber; }},
        {"amplitude", "1.5", "0 to 1", [](SeaDesc& d) { d.amplitude = 1.5f; }},
        {"amplitude", "nan", "0 to 1", [&](SeaDesc& d) { d.amplitude = notANumber; }},
        {"swell", "2", "0 to 1", [](SeaDesc& d) { d.swell = 2; }},
        {"swell", "nan", "0 to 1", [&](SeaDesc& d) { d.swell = notANumber; }},
        {"choppiness", "-1", "0 to 10", [](SeaDesc& d) { d.choppiness = -1; }},
        {"choppiness", "nan", "0 to 10", [&](SeaDesc& d) { d.choppiness = notANumber; }},
        {"samples", "8", "16 to 1024", [](SeaDesc& d) { d.samples = 8; }},
        {"samples", "2048", "16 to 1024", [](SeaDesc& d) { d.samples = 2048; }},
        {"samples", "100", "power of two", [](SeaDesc& d) { d.samples = 100; }},
        {"cascades", "0", "1 to 4", [](SeaDesc& d) { d.cascades = 0; }},
        {"cascades", "5", "1 to 4", [](SeaDesc& d) { d.cascades = 5; }},
        {"largestPatch", "0.5", "1 to 100000", [](SeaDesc& d) { d.largestPatch = 0.5f; }},
        {"largestPatch", "nan", "1 to 100000", [&](SeaDesc& d) { d.largestPatch = notANumber; }},
        {"largestPatch", "200000", "1 to 100000", [](SeaDesc& d) { d.largestPatch = 200000; }},
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
