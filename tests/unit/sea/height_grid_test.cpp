#include "seaglass/sea.h"

#include "tests/unit/sea/sea_support.h"
#include "water/sea/fourier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstring>
#include <limits>
#include <numbers>
#include <thread>
#include <vector>

namespace {

using namespace seaglass;
using tests::makeSea;
using tests::Maps;
using tests::SeaPtr;
using tests::Waves;

struct GridDeleter {
    void operator()(HeightGrid* grid) const { destroyHeightGrid(grid); }
};
using GridPtr = std::unique_ptr<HeightGrid, GridDeleter>;

std::vector<double> scattered(size_t count) {
    std::vector<double> points(2 * count);
    for (size_t i = 0; i < points.size(); ++i)
        points[i] = std::fmod(71.37 * static_cast<double>(i * i), 4900) - 2300;
    return points;
}

std::vector<HeightSample> onGrid(const HeightGrid& grid, const std::vector<double>& points) {
    std::vector<HeightSample> samples(points.size() / 2);
    sampleHeights(grid, points.data(), samples.size(), samples.data());
    return samples;
}

std::vector<HeightSample> analytic(const Sea& sea, double time, const std::vector<double>& points) {
    std::vector<HeightSample> samples(points.size() / 2);
    sampleHeights(sea, time, points.data(), samples.size(), samples.data());
    return samples;
}

bool same(const std::vector<HeightSample>& a, const std::vector<HeightSample>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

TEST(Fourier, IsTheSumItStandsFor) {
    for (const size_t points : {16u, 32u, 64u, 512u}) {
        constexpr size_t width = 2;
        std::vector<Complex4> rows(points * width), scratch(points * width);
        for (size_t i = 0; i < rows.size(); ++i)
            for (size_t l = 0; l < 4; ++l) {
                rows[i].re[l] = static_cast<float>(std::sin(1.7 * static_cast<double>(4 * i + l)));
                rows[i].im[l] = static_cast<float>(std::cos(2.3 * static_cast<double>(4 * i + l)));
            }
        const auto before = rows;
        InverseFourier(points).transform(rows.data(), scratch.data(), width);
        double error = 0, energy = 0;
        for (size_t j = 0; j < points; ++j)
            for (size_t x = 0; x < width; ++x)
                for (size_t l = 0; l < 4; ++l) {
                    std::complex<double> sum = 0;
                    for (size_t k = 0; k < points; ++k) {
                        const Complex4& in = before[k * width + x];
                        const double turns =
                            static_cast<double>(j * k % points) / static_cast<double>(points);
                        sum += std::complex<double>(in.re[l], in.im[l]) *
                               std::polar(1.0, 2 * std::numbers::pi * turns);
                    }
                    const Complex4& out = rows[j * width + x];
                    error += std::norm(std::complex<double>(out.re[l], out.im[l]) - sum);
                    energy += std::norm(sum);
                }
        EXPECT_LT(std::sqrt(error / energy), 5e-7) << points;
    }
}

// What the GPU draws: samples of the maps, moved by their displacement.
TEST(HeightGrid, LiesWhereTheMapsPutTheirSamples) {
    SeaDesc desc;
    desc.cascades = 1;
    desc.windDirection = 1.1f;
    desc.samples = 128;
    desc.choppiness = 0.8f;
    desc.warp = 0;
    const auto sea = makeSea(desc);
    constexpr double time = 25;
    const Maps maps = Waves(*sea).at(0, time);
    const GridPtr grid(createHeightGrid(*sea, time));
    const double spacing = cascade(*sea, 0).patch / 128;
    std::vector<double> points;
    std::vector<size_t> texels;
    for (size_t t = 0; t < maps.texels(); t += 7) {
        if (maps.jacobian(t) < 0.2) continue;
        texels.push_back(t);
        points.push_back(static_cast<double>(t % 128) * spacing +
                         static_cast<double>(maps.displacement[4 * t]));
        points.push_back(static_cast<double>(t / 128) * spacing +
                         static_cast<double>(maps.displacement[4 * t + 2]));
    }
    const auto found = onGrid(*grid, points);
    const double tolerance = 1e-4 * significantWaveHeight(*sea);
    for (size_t i = 0; i < found.size(); ++i) {
        const float* s = &maps.derivatives[4 * texels[i]];
        const float shear = maps.displacement[4 * texels[i] + 3];
        EXPECT_EQ(found[i].folded, 0u);
        EXPECT_NEAR(found[i].height, maps.height(texels[i]), tolerance);
        const float* n = found[i].normal;
        EXPECT_NEAR(n[0] * (1 + s[2]) + n[1] * s[0] + n[2] * shear, 0, 1e-3);
        EXPECT_NEAR(n[0] * shear + n[1] * s[1] + n[2] * (1 + s[3]), 0, 1e-3);
    }
}

TEST(HeightGrid, AgreesWithTheSumOfModes) {
    for (const float wind : {5.0f, 10.0f, 20.0f}) {
        SeaDesc desc;
        desc.windSpeed = wind;
        desc.windDirection = 0.6f;
        const auto sea = makeSea(desc);
        const auto points = scattered(400);
        constexpr double time = 1234.5;
        const GridPtr grid(createHeightGrid(*sea, time));
        const auto found = onGrid(*grid, points), expected = analytic(*sea, time, points);
        const double hs = significantWaveHeight(*sea);
        double squares = 0, worst = 0, speed = 0, velocity = 0, tilt = 0;
        size_t settled = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            if (found[i].folded || expected[i].folded) continue;
            ++settled;
            const double off = static_cast<double>(found[i].height) - static_cast<double>(expected[i].height);
            squares += off * off;
            worst = std::max(worst, std::abs(off));
            for (size_t a = 0; a < 3; ++a) {
                velocity += std::pow(static_cast<double>(found[i].velocity[a]) - expected[i].velocity[a], 2);
                speed += std::pow(static_cast<double>(expected[i].velocity[a]), 2);
                tilt += std::pow(static_cast<double>(found[i].normal[a]) - expected[i].normal[a], 2);
            }
        }
        const double mean = std::sqrt(squares / static_cast<double>(settled)) / hs;
        tilt = std::sqrt(tilt / static_cast<double>(settled));
        std::printf(
            "wind %2.0f: off by %.2f %% of Hs in the mean, %.2f %% at most; velocities by %.1f %%, normals "
            "by %.3f; %zu of %zu not folded\n",
            static_cast<double>(wind), 100 * mean, 100 * worst / hs, 100 * std::sqrt(velocity / speed), tilt,
            settled, found.size());
        EXPECT_GT(settled, 360u);
        EXPECT_LT(mean, 0.01);
        EXPECT_LT(worst / hs, 0.05);
        EXPECT_LT(std::sqrt(velocity / speed), 0.1);
        EXPECT_LT(tilt, 0.1);
    }
}

TEST(HeightGrid, SaysWhereTheSurfaceFolds) {
    SeaDesc desc;
    desc.samples = 64;
    desc.choppiness = 10;
    const auto sea = makeSea(desc);
    const GridPtr grid(createHeightGrid(*sea, 5));
    const auto found = onGrid(*grid, scattered(300));
    size_t folded = 0;
    for (const HeightSample& s : found) {
        folded += s.folded;
        EXPECT_TRUE(std::isfinite(s.height));
        EXPECT_GE(s.normal[1], 0);
    }
    EXPECT_GT(folded, 20u);

    desc.choppiness = 0;
    const auto plain = makeSea(desc);
    const GridPtr smooth(createHeightGrid(*plain, 5));
    for (const HeightSample& s : onGrid(*smooth, scattered(100))) EXPECT_EQ(s.folded, 0u);
}

TEST(HeightGrid, IsFiniteInEverySeaThatMayBeAskedFor) {
    for (const float wind : {0.0f, 0.3f, 2.0f, 40.0f, 100.0f})
        for (const float choppiness : {0.0f, 1.0f, 10.0f}) {
            SeaDesc desc;
            desc.windSpeed = wind;
            desc.choppiness = choppiness;
            desc.fetch = 1000e3f;
            desc.samples = 64;
            const auto sea = makeSea(desc);
            const GridPtr grid(createHeightGrid(*sea, 77));
            double highest = 0;
            for (const HeightSample& s : onGrid(*grid, scattered(200))) {
                EXPECT_TRUE(std::isfinite(s.height + s.normal[0] + s.normal[1] + s.normal[2] + s.velocity[0] +
                                          s.velocity[1] + s.velocity[2]));
                highest = std::max(highest, std::abs(static_cast<double>(s.height)));
            }
            const double hs = significantWaveHeight(*sea);
            EXPECT_LE(highest, 1.5 * hs);
            EXPECT_GE(highest, 0.3 * hs) << "wind " << wind << ", choppiness " << choppiness;
        }
}

TEST(HeightGrid, SameBitsHoweverItCameToItsTime) {
    const auto sea = makeSea(tests::oneCascade());
    const GridPtr fresh(createHeightGrid(*sea, 42.125)), moved(createHeightGrid(*sea, -3));
    setTime(*moved, 1e9);
    setTime(*moved, 42.125 + 4096 * 8000.0);
    const auto points = scattered(101);
    const auto expected = onGrid(*fresh, points);
    EXPECT_TRUE(same(expected, onGrid(*moved, points)));
    for (size_t i = 0; i < expected.size(); i += 13) {
        HeightSample alone;
        sampleHeights(*fresh, &points[2 * i], 1, &alone);
        EXPECT_EQ(std::memcmp(&alone, &expected[i], sizeof alone), 0) << i;
    }
    std::vector<std::vector<HeightSample>> several(4);
    {
        std::vector<std::jthread> threads;
        for (auto& samples : several) threads.emplace_back([&] { samples = onGrid(*fresh, points); });
    }
    for (const auto& samples : several) EXPECT_TRUE(same(samples, expected));
}

TEST(HeightGrid, SameBitsBesidePointsThatAreFarOrNone) {
    SeaDesc desc;
    desc.samples = 64;
    const auto sea = makeSea(desc);
    const GridPtr grid(createHeightGrid(*sea, 3));
    const auto points = scattered(40);
    const auto expected = onGrid(*grid, points);
    auto beside = points;
    for (size_t i = 1; i < 40; i += 2)
        beside[2 * i + i / 2 % 2] = i % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : 3e15;
    const auto found = onGrid(*grid, beside);
    for (size_t i = 0; i < 40; i += 2)
        EXPECT_EQ(std::memcmp(&found[i], &expected[i], sizeof expected[i]), 0) << i;
}

TEST(HeightGrid, RepeatsWithItsTilesHoweverFar) {
    const auto sea = makeSea(tests::oneCascade());
    const GridPtr grid(createHeightGrid(*sea, 12.5));
    const auto heightAt = [&](double u, double v) {
        const double point[] = {u, v};
        HeightSample sample;
        sampleHeights(*grid, point, 1, &sample);
        return sample.height;
    };
    const double here = heightAt(100.25, -31.5);
    EXPECT_NEAR(here, heightAt(100.25 + 512 * 1e6, -31.5 - 512 * 1e6), 1e-3);
    EXPECT_NEAR(heightAt(96, -32), heightAt(96 + 512 * 0x1p40, -32 - 512 * 0x1p40), 1e-4);
    EXPECT_NE(here, heightAt(100.25 + 256, -31.5));
}

TEST(HeightGrid, IsCalmWhereThereIsNoPointOrNoWind) {
    const auto sea = makeSea(tests::oneCascade());
    const GridPtr grid(createHeightGrid(*sea, 0));
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const auto found = onGrid(*grid, {bad, 0, 1, 1});
        EXPECT_EQ(found[0].height, 0);
        EXPECT_EQ(found[0].normal[1], 1);
        EXPECT_EQ(found[0].folded, 1u);
        EXPECT_EQ(found[1].folded, 0u);
        EXPECT_TRUE(std::isfinite(onGrid(*grid, {1e300, -1e300})[0].height));
    }
    SeaDesc calm;
    calm.windSpeed = 0;
    const auto flat = makeSea(calm);
    const GridPtr still(createHeightGrid(*flat, 3));
    ASSERT_TRUE(still);
    EXPECT_EQ(onGrid(*still, {5, 6})[0].height, 0);
    EXPECT_EQ(onGrid(*still, {5, 6})[0].folded, 0u);
}

} // namespace
