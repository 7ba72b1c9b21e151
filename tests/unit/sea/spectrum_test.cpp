#include "water/spectrum/spectrum.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace seaglass;
using tests::moment;

constexpr double infinity = std::numeric_limits<double>::infinity();

double waveHeight(const Spectrum& spectrum) {
    return 4 * std::sqrt(moment(spectrum, 0, infinity));
}
double peakPeriod(const Spectrum& spectrum) {
    return 2 * std::numbers::pi / spectrum.peak;
}

SeaDesc piersonMoskowitz(float wind) {
    SeaDesc desc;
    desc.spectrum = SpectrumModel::piersonMoskowitz;
    desc.windSpeed = wind;
    return desc;
}

SeaDesc jonswap(float wind, float fetch) {
    SeaDesc desc;
    desc.windSpeed = wind;
    desc.fetch = fetch;
    desc.capFetch = false;
    return desc;
}

TEST(Spectrum, PiersonMoskowitzHasItsHeightsAndPeriods) {
    struct Row {
        float wind;
        double height, period;
    };
    for (const Row row :
         {Row{5, 0.561, 3.747}, Row{7.5f, 1.263, 5.620}, Row{10, 2.245, 7.493}, Row{12.5f, 3.508, 9.366},
          Row{15, 5.052, 11.24}, Row{20, 8.981, 14.99}, Row{25, 14.03, 18.73}}) {
        const Spectrum spectrum = makeSpectrum(piersonMoskowitz(row.wind));
        EXPECT_NEAR(waveHeight(spectrum) / row.height, 1, 1e-3) << row.wind << " m/s";
        EXPECT_NEAR(peakPeriod(spectrum) / row.period, 1, 1e-3) << row.wind << " m/s";
    }
}

TEST(Spectrum, PiersonMoskowitzCrossesZeroAsPublished) {
    const Spectrum spectrum = makeSpectrum(piersonMoskowitz(10));
    const double zeroCrossing =
        2 * std::numbers::pi * std::sqrt(moment(spectrum, 0, infinity) / moment(spectrum, 0, infinity, 2));
    EXPECT_NEAR(zeroCrossing / peakPeriod(spectrum), 0.710, 1e-3);
}

TEST(Spectrum, JonswapHasItsHeightsAndPeriods) {
    struct Row {
        float wind, fetch;
        double alpha, period, height;
    };
    for (const Row row : {Row{10, 10e3f, 0.01670, 2.893, 0.594}, Row{10, 100e3f, 0.01006, 6.232, 2.139},
                          Row{15, 100e3f, 0.01203, 7.134, 3.064}, Row{15, 300e3f, 0.00944, 10.29, 5.647},
                          Row{20, 300e3f, 0.01072, 11.33, 7.288}}) {
        const Spectrum spectrum = makeSpectrum(jonswap(row.wind, row.fetch));
        EXPECT_NEAR(spectrum.alpha, row.alpha, 6e-6) << row.wind << " m/s over " << row.fetch << " m";
        EXPECT_NEAR(peakPeriod(spectrum) / row.period, 1, 1e-3)
            << row.wind << " m/s over " << row.fetch << " m";
        EXPECT_NEAR(waveHeight(spectrum) / row.height, 1, 1e-3)
            << row.wind << " m/s over " << row.fetch << " m";
    }
}

TEST(Spectrum, VarianceIsItsIntegral) {
    SeaDesc shallow = jonswap(15, 300e3f);
    shallow.spectrum = SpectrumModel::tma;
    for (const float depth : {3.0f, 20.0f, 200.0f}) {
        shallow.depth = depth;
        const Spectrum spectrum = makeSpectrum(shallow);
        EXPECT_NEAR(variance(spectrum) / moment(spectrum, 0, infinity), 1, 1e-3) << depth;
    }
    const Spectrum old = makeSpectrum(SwellDesc{.height = 2});
    EXPECT_NEAR(variance(old) / moment(old, 0, infinity), 1, 1e-3);
    const SpectrumSample rows[] = {{0.05f, 0}, {0.1f, 4}, {0.2f, 1}, {0.4f, 0}};
    SeaDesc desc;
    desc.spectrum = SpectrumModel::table;
    desc.spectrumTable = rows;
    desc.spectrumTableCount = 4;
    EXPECT_NEAR(variance(makeSpectrum(desc)), 0.45, 1e-6);
}

TEST(Spectrum, PeakEnhancementMultipliesTheEnergy) {
    SeaDesc desc = jonswap(10, 100e3f);
    desc.peakEnhancement = 1;
    const double plain = moment(makeSpectrum(desc), 0, infinity);
    for (const auto& [gamma, factor] : {std::pair{2.0f, 1.246}, {3.3f, 1.525}, {5.0f, 1.858}}) {
        desc.peakEnhancement = gamma;
        EXPECT_NEAR(moment(makeSpectrum(desc), 0, infinity) / plain, factor, 1e-3) << gamma;
    }
}

TEST(Spectrum, IsLargestAtItsPeak) {
    for (const SeaDesc& desc : {piersonMoskowitz(10), jonswap(10, 100e3f)}) {
        const Spectrum spectrum = makeSpectrum(desc);
        for (const double off : {0.9, 0.99, 1.01, 1.1})
            EXPECT_LT(energy(spectrum, off * spectrum.peak), energy(spectrum, spectrum.peak)) << off;
    }
}

TEST(Spectrum, CapHoldsTheFetchAtFullDevelopment) {
    SeaDesc desc = jonswap(10, 1e6f);
    const double uncapped = waveHeight(makeSpectrum(desc));
    desc.capFetch = true;
    const double capped = waveHeight(makeSpectrum(desc));
    const double fullyDeveloped = waveHeight(makeSpectrum(piersonMoskowitz(10)));
    EXPECT_NEAR(capped / fullyDeveloped, 1, 0.05);
    EXPECT_GT(uncapped, 2 * capped);

    desc.fetch = 50e3f; // chi = 4905
    SeaDesc open = desc;
    open.capFetch = false;
    EXPECT_EQ(makeSpectrum(desc).alpha, makeSpectrum(open).alpha);
}

TEST(Spectrum, BottomLowersItAsPublished) {
    // Kitaigorodskii's factor of wh = w sqrt(h/g).
    for (const auto& [wh, factor] : {std::pair{0.5, 0.1248}, {1.0, 0.4828}, {1.5, 0.8785}, {2.0, 0.9934}}) {
        for (const double depth : {0.3, 12.0})
            EXPECT_NEAR(kitaigorodskii(wh * std::sqrt(gravity / depth), depth), factor, 5e-5) << wh;
    }
    EXPECT_EQ(kitaigorodskii(1, infinity), 1);
    EXPECT_NEAR(kitaigorodskii(1e-3, 1), 1e-6 / gravity / 2, 1e-12);
    EXPECT_EQ(kitaigorodskii(1e-300, 1e-30), 0);
    double last = 0;
    for (double omega = 1e-5; omega < 10; omega *= 1.01) {
        const double factor = kitaigorodskii(omega, 10);
        EXPECT_GE(factor, last) << omega;
        EXPECT_LE(factor, 1) << omega;
        last = factor;
    }
}

TEST(Spectrum, TmaHasItsHeights) {
    for (const auto& [depth, height] :
         {std::pair{5.0f, 2.17}, {10.0f, 2.97}, {20.0f, 3.95}, {50.0f, 5.20}, {INFINITY, 5.65}}) {
        SeaDesc desc = jonswap(15, 300e3f);
        desc.spectrum = SpectrumModel::tma;
        desc.depth = depth;
        EXPECT_NEAR(waveHeight(makeSpectrum(desc)) / height, 1, 3e-3) << depth << " m";
        desc.spectrum = SpectrumModel::jonswap;
        EXPECT_NEAR(waveHeight(makeSpectrum(desc)) / 5.65, 1, 3e-3) << "JONSWAP heeds no bottom";
    }
}

TEST(Spectrum, PhillipsIsThatOfWaveNumbers) {
    SeaDesc desc;
    desc.spectrum = SpectrumModel::phillips;
    desc.windSpeed = 12;
    const Spectrum spectrum = makeSpectrum(desc);
    const double length = 12 * 12 / gravity;
    for (const double k : {0.5 / length, 1 / length, 8 / length}) {
        // alpha/2 k^-3 exp(-1/(k L)^2) dk = S dw, w^2 = g k.
        const double perWaveNumber = 8.1e-3 / 2 / (k * k * k) * std::exp(-1 / (k * length * k * length));
        const double groupSpeed = 0.5 * std::sqrt(gravity / k);
        EXPECT_NEAR(energy(spectrum, std::sqrt(gravity * k)) * groupSpeed / perWaveNumber, 1, 1e-9);
    }
    // Its integral is alpha L^2/4.
    EXPECT_NEAR(waveHeight(spectrum), 4 * std::sqrt(8.1e-3) * length / 2, 1e-3);
}

TEST(Spectrum, SwellHasTheHeightAndPeriodItIsGiven) {
    SwellDesc swell;
    swell.height = 1.7f;
    swell.peakPeriod = 11;
    for (const float bandwidth : {0.02f, 0.08f, 0.25f}) {
        swell.bandwidth = bandwidth;
        const Spectrum spectrum = makeSpectrum(swell);
        EXPECT_NEAR(waveHeight(spectrum), 1.7, 2e-3) << bandwidth;
        EXPECT_NEAR(moment(spectrum, 0, infinity, 1) / moment(spectrum, 0, infinity),
                    2 * std::numbers::pi / 11, 2e-3);
        EXPECT_GT(energy(spectrum, spectrum.peak), energy(spectrum, 1.01 * spectrum.peak));
        EXPECT_GT(energy(spectrum, spectrum.peak), energy(spectrum, 0.99 * spectrum.peak));
    }
}

TEST(Spectrum, TableIsLinearBetweenItsSamples) {
    const SpectrumSample samples[] = {{0.05f, 0}, {0.1f, 4}, {0.2f, 1}, {0.4f, 0}};
    SeaDesc desc;
    desc.spectrum = SpectrumModel::table;
    desc.spectrumTable = samples;
    desc.spectrumTableCount = 4;
    const Spectrum spectrum = makeSpectrum(desc);
    const double turn = 2 * std::numbers::pi;
    EXPECT_NEAR(spectrum.peak, turn * 0.1, 1e-6);
    for (const auto& [hertz, density] :
         {std::pair{0.04, 0.0}, {0.075, 2.0}, {0.1, 4.0}, {0.15, 2.5}, {0.3, 0.5}, {0.41, 0.0}})
        EXPECT_NEAR(energy(spectrum, turn * hertz) * turn, density, 1e-5) << hertz;
    // Trapezia of 0.1, 0.25 and 0.1 m^2.
    EXPECT_NEAR(waveHeight(spectrum), 4 * std::sqrt(0.45), 1e-3);
}

TEST(Spectrum, IsFiniteAndNeverNegative) {
    for (const float wind : {0.01f, 100.0f}) {
        for (const float fetch : {1.0f, 1e6f}) {
            for (const bool cap : {false, true}) {
                SeaDesc desc = jonswap(wind, fetch);
                desc.capFetch = cap;
                const Spectrum spectrum = makeSpectrum(desc);
                for (const double omega : {-1.0, 0.0, 1e-300, 1e-80, 1e-3, 1.0, 1e3, 1e12}) {
                    const double s = energy(spectrum, omega);
                    EXPECT_TRUE(std::isfinite(s) && s >= 0) << wind << " m/s, " << fetch << " m, " << omega;
                }
            }
        }
    }
}

} // namespace
