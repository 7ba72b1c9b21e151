// The body of the surf: how crests sharpen and lean as the bed comes near, what they break into, and what the
// swash carries.
#include "tests/unit/sea/sea_support.h"
#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

using namespace seaglass;
using namespace tests;

namespace {

constexpr double pi = std::numbers::pi, slope = 1.0 / 21;

/// The demos' swell, straight onto a plane; the water's edge is at v = 0.
SeaPtr surfBeach() {
    return beachOf({1.6f, 9.0f, static_cast<float>(pi / 2), 0.1f, 30}, slope, 400);
}

/// Third moments of a record and of its Hilbert transform, in deviations: 0 for waves that nothing sharpens.
struct Sharpness {
    double skewness = 0, asymmetry = 0;
    double bound() const { return std::hypot(skewness, asymmetry); }
    double biphaseDegrees() const { return std::atan2(asymmetry, skewness) * 180 / pi; }
};

/// By the plain sum of its Fourier series up to the eighth harmonic of the swell.
Sharpness sharpnessOf(const std::vector<double>& record, double step) {
    const size_t count = record.size();
    const auto harmonics = static_cast<size_t>(static_cast<double>(count) * step / 9 * 8);
    std::vector<std::complex<double>> analytic(count), turns(count);
    for (size_t i = 0; i < count; ++i)
        turns[i] = std::polar(1.0, 2 * pi * static_cast<double>(i) / static_cast<double>(count));
    for (size_t m = 1; m < harmonics; ++m) {
        std::complex<double> sum;
        for (size_t i = 0; i < count; ++i) sum += record[i] * std::conj(turns[i * m % count]);
        for (size_t i = 0; i < count; ++i) analytic[i] += sum * turns[i * m % count];
    }
    double second = 0, third = 0, turned = 0;
    for (const std::complex<double>& a : analytic) {
        second += a.real() * a.real();
        third += std::pow(a.real(), 3);
        turned += std::pow(a.imag(), 3);
    }
    const double n = static_cast<double>(count), cubed = std::pow(second / n, 1.5);
    return {third / n / cubed, turned / n / cubed};
}

/// Ruessink, Ramaekers and van Rijn 2012, of field data, by the Ursell number.
Sharpness ruessink(double ursell) {
    const double bound = 0.857 / (1 + std::exp((-0.471 - std::log10(ursell)) / 0.297));
    const double biphase = (-90 + 90 * std::tanh(0.815 / std::pow(ursell, 0.672))) * pi / 180;
    return {bound * std::cos(biphase), bound * std::sin(biphase)};
}

TEST(Surf, CrestsSharpenAndLeanAsOnBeaches) {
    const SeaPtr sea = surfBeach();
    constexpr double step = 0.3;
    constexpr double depths[] = {12, 8, 5, 3, 2, 1.2};
    std::vector<double> records[std::size(depths)];
    for (double time = 0; time < 600; time += step) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3);
        for (size_t i = 0; i < std::size(depths); ++i)
            records[i].push_back(sea->shore->waveAt(signal, 0, -depths[i] / slope, 0).height);
    }
    std::printf("depth, Ursell number, bound harmonics and biphase, Ruessink's\n");
    for (size_t i = 0; i < std::size(depths); ++i) {
        const double depth = depths[i];
        const Sharpness seen = sharpnessOf(records[i], step);
        const double k = 2 * pi / 9 / std::sqrt(9.81 * depth);
        const double height = 4 * double{sea->shore->at(0, -depth / slope).height};
        const double ursell = 0.75 * (height / 2) * k / std::pow(k * depth, 3);
        const Sharpness found = ruessink(ursell);
        std::printf("%.1f m, %.2f: %.2f at %.0f, %.2f at %.0f\n", depth, ursell, seen.bound(),
                    seen.biphaseDegrees(), found.bound(), found.biphaseDegrees());
        EXPECT_NEAR(seen.biphaseDegrees(), found.biphaseDegrees(), 20) << depth;
        EXPECT_GT(seen.bound(), 0.7 * found.bound()) << depth;
        EXPECT_LT(seen.bound(), 2.3 * found.bound() + 0.3) << depth;
    }
}

/// Of the surface as it stands, after its points moved; up towards the shore.
double riseOf(const ShoreWave& wave) {
    return wave.slope[1] / std::max(1 + wave.stretch[1], 0.1);
}

TEST(Surf, FrontsRiseToAWallBeforeTheyBreak) {
    const SeaPtr sea = surfBeach();
    constexpr double depths[] = {12, 6, 4, 3};
    double front[std::size(depths)] = {}, back[std::size(depths)] = {};
    for (double time = 0; time < 300; time += 0.1) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3);
        for (size_t i = 0; i < std::size(depths); ++i) {
            const ShoreWave wave = sea->shore->waveAt(signal, 0, -depths[i] / slope, 0);
            if (wave.foam > 0.1) continue;
            front[i] = std::max(front[i], -riseOf(wave));
            back[i] = std::max(back[i], riseOf(wave));
        }
    }
    for (size_t i = 0; i < std::size(depths); ++i)
        std::printf("over %.0f m of water fronts that are not white are as steep as %.2f, backs %.2f\n",
                    depths[i], front[i], back[i]);
    EXPECT_LT(front[0], 0.2);
    EXPECT_GT(front[3], 0.8) << "a wall";
    EXPECT_GT(front[3], 2 * back[3]);
}

TEST(Surf, WhiteWaterRollsOnTheFrontsOfWaves) {
    const SeaPtr sea = surfBeach();
    size_t rolling = 0, onFronts = 0;
    double cover = 0, places = 0;
    for (double time = 0; time < 90; time += 0.5) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3.2);
        for (double v = -40; v < -14; v += 0.25) {
            const ShoreWave wave = sea->shore->waveAt(signal, 0, v, 0);
            const ShoreWave behind = sea->shore->waveAt(signal, 0, v - 4, 0),
                            ahead = sea->shore->waveAt(signal, 0, v + 4, 0);
            cover += wave.foam;
            ++places;
            if (wave.foam < 0.9) continue;
            ++rolling;
            onFronts += behind.height > ahead.height ? 1 : 0;
        }
    }
    std::printf("%zu places of rollers, %.2f of them on a front; cover %.2f\n", rolling,
                double(onFronts) / double(rolling), cover / places);
    EXPECT_GT(rolling, 500u);
    EXPECT_GT(double(onFronts), 0.75 * double(rolling));
    EXPECT_LT(cover / places, 0.5) << "white water goes before the next wave comes";
}

TEST(Surf, FoamIsCarriedWithoutBeingCombed) {
    const SeaPtr sea = surfBeach();
    double most = 0, farthest = 0;
    for (double time = 0; time < 60; time += 0.7) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3.2);
        for (double v = -12; v < 14; v += 0.5) {
            const double here = sea->shore->waveAt(signal, 0, v, 0).advected[1],
                         beside = sea->shore->waveAt(signal, 0, v + 0.5, 0).advected[1];
            most = std::max(most, std::abs(beside - here) / 0.5);
            farthest = std::max(farthest, std::abs(here));
        }
    }
    std::printf("carried %.2f m at most, drawn out by %.2f\n", farthest, most);
    EXPECT_GT(farthest, 1);
    EXPECT_LT(most, 0.4);
}

} // namespace
