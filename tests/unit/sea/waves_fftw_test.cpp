#include "seaglass/waves_fftw.h"

#include "tests/unit/sea/sea_support.h"
#include "tests/unit/sea/starved.h"
#include "tests/unit/sea/wave_truth.h"
#include "water/sea/phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace {

using namespace seaglass;
using tests::directSum;
using tests::DirectSum;
using tests::makeSea;
using tests::Maps;
using tests::Waves;

constexpr double tau = 2 * std::numbers::pi;
constexpr double year = 365.25 * 86400;

// The eight fields of a texel: displacement, then derivatives.
std::array<double, 8> fields(const Maps& maps, size_t texel) {
    std::array<double, 8> out;
    for (size_t f = 0; f < 4; ++f) {
        out[f] = maps.displacement[4 * texel + f];
        out[4 + f] = maps.derivatives[4 * texel + f];
    }
    return out;
}

std::array<double, 8> fields(const DirectSum& s) {
    return {s.dx, s.h, s.dz, s.dxv, s.hu, s.hv, s.dxu, s.dzv};
}

std::array<double, 8> rootMeanSquare(const Maps& maps) {
    std::array<double, 8> sum{};
    for (size_t t = 0; t < maps.texels(); ++t) {
        const auto at = fields(maps, t);
        for (size_t f = 0; f < 8; ++f) sum[f] += at[f] * at[f];
    }
    for (double& s : sum) s = std::sqrt(s / static_cast<double>(maps.texels()));
    return sum;
}

void expectDirectSum(const Sea& sea, uint32_t c, double time, const Maps& maps, size_t i, size_t j) {
    const double spacing = cascade(sea, c).patch / static_cast<double>(maps.samples);
    const size_t texel = j * maps.samples + i;
    const DirectSum sum =
        directSum(sea, c, time, static_cast<double>(i) * spacing, static_cast<double>(j) * spacing);
    const auto found = fields(maps, texel), expected = fields(sum), scale = rootMeanSquare(maps);
    for (size_t f = 0; f < 8; ++f)
        EXPECT_NEAR(found[f], expected[f], 2e-5 * scale[f])
            << "field " << f << " of cascade " << c << " at " << i << ", " << j;
    const std::array<double, 4> moments{sum.hu * sum.hu, sum.hv * sum.hv, sum.hu * sum.hv, sum.dxv};
    const std::array<double, 4> size{scale[4] * scale[4], scale[5] * scale[5], scale[4] * scale[5], scale[3]};
    for (size_t f = 0; f < 4; ++f)
        EXPECT_NEAR(maps.moments[4 * texel + f], moments[f], 1e-4 * size[f]) << "moment " << f;
}

TEST(WavesFftw, MapsAreTheSumOfTheModes) {
    SeaDesc desc;
    desc.windDirection = 0.7f;
    desc.choppiness = 1.3f;
    const auto sea = makeSea(desc);
    Waves waves(*sea);
    std::mt19937 random(1);
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
        for (const double time : {0.0, 1234.5}) {
            const Maps maps = waves.at(c, time);
            expectDirectSum(*sea, c, time, maps, 0, 0);
            for (int draw = 0; draw < 8; ++draw)
                expectDirectSum(*sea, c, time, maps, random() % desc.samples, random() % desc.samples);
        }
    }
}

TEST(WavesFftw, TransformsLikeADirectSumEverywhere) {
    SeaDesc desc = tests::oneCascade();
    desc.samples = 32;
    const auto sea = makeSea(desc);
    const Maps maps = Waves(*sea).at(0, 77);
    double error = 0, size = 0;
    for (size_t j = 0; j < 32; ++j) {
        for (size_t i = 0; i < 32; ++i) {
            const double spacing = 512.0 / 32;
            const double exact =
                directSum(*sea, 0, 77, static_cast<double>(i) * spacing, static_cast<double>(j) * spacing).h;
            const double off = maps.height(j * 32 + i) - exact;
            error += off * off;
            size += exact * exact;
        }
    }
    EXPECT_LT(std::sqrt(error / size), 1e-6);
}

TEST(WavesFftw, DerivativesAreFiniteDifferences) {
    SeaDesc desc = tests::oneCascade();
    desc.windDirection = 2.5f;
    const auto sea = makeSea(desc);
    constexpr double time = 50, step = 0.01;
    const Maps maps = Waves(*sea).at(0, time);
    const double spacing = 512.0 / 64;
    const auto scale = rootMeanSquare(maps);
    for (const auto& [i, j] : {std::pair<size_t, size_t>{0, 0}, {5, 40}, {63, 1}, {31, 32}}) {
        const double u = static_cast<double>(i) * spacing, v = static_cast<double>(j) * spacing;
        const auto at = [&](double du, double dv) { return directSum(*sea, 0, time, u + du, v + dv); };
        const DirectSum east = at(step, 0), west = at(-step, 0), north = at(0, step), south = at(0, -step);
        const auto found = fields(maps, j * 64 + i);
        EXPECT_NEAR(found[3], (north.dx - south.dx) / (2 * step), 1e-4 * scale[3]);
        EXPECT_NEAR(found[3], (east.dz - west.dz) / (2 * step), 1e-4 * scale[3]);
        EXPECT_NEAR(found[4], (east.h - west.h) / (2 * step), 1e-4 * scale[4]);
        EXPECT_NEAR(found[5], (north.h - south.h) / (2 * step), 1e-4 * scale[5]);
        EXPECT_NEAR(found[6], (east.dx - west.dx) / (2 * step), 1e-4 * scale[6]);
        EXPECT_NEAR(found[7], (north.dz - south.dz) / (2 * step), 1e-4 * scale[7]);
    }
}

TEST(WavesFftw, KeepsTheEnergyOfEachCascade) {
    for (const uint32_t samples : {16u, 128u, 512u}) {
        SeaDesc desc;
        desc.samples = samples;
        const auto sea = makeSea(desc);
        Waves waves(*sea);
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
            const Maps maps = waves.at(c, 33);
            double onGrid = 0;
            for (size_t t = 0; t < maps.texels(); ++t) onGrid += maps.height(t) * maps.height(t);
            onGrid /= static_cast<double>(maps.texels());

            const Modes& modes = sea->modes[c];
            double inModes = 0;
            for (size_t m = 0; m < modes.frequency.size(); ++m) {
                const auto turn = std::polar(1.0, modes.frequency[m] * tau / desc.loopPeriod * 33);
                const auto h =
                    std::complex<double>(modes.forwardRe[m], modes.forwardIm[m]) * turn +
                    std::complex<double>(modes.backwardRe[m], modes.backwardIm[m]) * std::conj(turn);
                inModes += 2 * std::norm(h);
            }
            EXPECT_NEAR(onGrid / inModes, 1, 1e-5) << samples << ", " << c;
        }
    }
}

TEST(WavesFftw, WavesTravelDownwind) {
    for (const float direction : {0.0f, 1.0f, 2.5f, -2.0f, 100.0f}) {
        SeaDesc desc;
        desc.samples = 128;
        desc.windDirection = direction;
        const auto sea = makeSea(desc);
        Waves waves(*sea);
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
            constexpr double step = 0.01;
            const Maps before = waves.at(c, 10 - step), now = waves.at(c, 10), after = waves.at(c, 10 + step);
            // A wave cos(k.x - wt) rises where it slopes down along its way.
            double along[2] = {};
            for (size_t t = 0; t < now.texels(); ++t) {
                const double rise = (after.height(t) - before.height(t)) / (2 * step);
                along[0] -= rise * now.derivatives[4 * t];
                along[1] -= rise * now.derivatives[4 * t + 1];
            }
            const double size = std::hypot(along[0], along[1]);
            ASSERT_GT(size, 0);
            const double wind = static_cast<double>(direction);
            const double cosine = (along[0] * std::cos(wind) + along[1] * std::sin(wind)) / size;
            EXPECT_GT(cosine, 0.97) << "wind towards " << direction << ", cascade " << c;
        }
    }
}

TEST(WavesFftw, CrestsAreSharperThanTroughs) {
    SeaDesc desc = tests::oneCascade();
    desc.samples = 256;
    desc.choppiness = 1;
    const auto sea = makeSea(desc);
    const Maps maps = Waves(*sea).at(0, 10);
    // J is the water's area over a texel's: drawn together at crests, spread out in troughs. (The skewness of
    // a random sea would not tell: to this order it is zero, whatever the sign.)
    double second = 0;
    for (size_t t = 0; t < maps.texels(); ++t) second += maps.height(t) * maps.height(t);
    second /= static_cast<double>(maps.texels());

    const double high = 2 * std::sqrt(second);
    double atCrests = 0, atTroughs = 0;
    size_t crests = 0, troughs = 0;
    for (size_t t = 0; t < maps.texels(); ++t) {
        if (maps.height(t) > high) atCrests += maps.jacobian(t), ++crests;
        if (maps.height(t) < -high) atTroughs += maps.jacobian(t), ++troughs;
    }
    EXPECT_LT(atCrests / static_cast<double>(crests), 0.9);
    EXPECT_GT(atTroughs / static_cast<double>(troughs), 1.1);
}

TEST(WavesFftw, SameBitsWhateverWasAskedBefore) {
    SeaDesc desc;
    desc.samples = 64;
    const auto sea = makeSea(desc), again = makeSea(desc);
    Waves fresh(*sea), used(*again);
    for (const double time : {3.0, -17.0, 1e9}) {
        for (const uint32_t c : {2u, 0u, 1u}) used.at(c, time);
    }
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) EXPECT_EQ(fresh.at(c, 42.125), used.at(c, 42.125)) << c;
}

TEST(WavesFftw, SameBitsOnTwoThreads) {
    for (const uint32_t samples : {16u, 64u, 256u}) {
        SeaDesc desc;
        desc.samples = samples;
        const auto sea = makeSea(desc);
        Waves one(*sea), two(*sea, *fftwWaves(2));
        for (uint32_t c = 0; c < cascadeCount(*sea); ++c) EXPECT_EQ(one.at(c, 7.5), two.at(c, 7.5)) << c;
    }
}

TEST(WavesFftw, AgreeWithDoublesWhateverTheSize) {
    double worst = 0;
    for (uint32_t samples = 16; samples <= 2048; samples *= 2) {
        SeaDesc desc;
        desc.samples = samples;
        const auto sea = makeSea(desc);
        Waves waves(*sea);
        constexpr double time = 100.125;
        // Doubles are slow: of the large ones the fullest cascade.
        const uint32_t count = cascadeCount(*sea);
        for (uint32_t c = samples > 256 ? count - 1 : 0; c < count; ++c) {
            const Maps maps = waves.at(c, time);
            const auto error =
                tests::waveError(tests::waveTruth(*sea, c, time), maps.displacement, maps.derivatives);
            for (size_t f = 0; f < error.relative.size(); ++f) {
                EXPECT_LT(error.relative[f], 5e-7) << samples << " samples, cascade " << c << ", field " << f;
                worst = std::max(worst, error.relative[f]);
            }
        }
    }
    std::printf("largest relative L2 error %.2e\n", worst);
}

TEST(WavesFftw, AMonthLaterFramesStillFollowEvenly) {
    const auto sea = makeSea(SeaDesc{});
    Waves waves(*sea);
    const double height = significantWaveHeight(*sea);
    std::vector<Maps> frames;
    for (int i = 0; i < 4; ++i) {
        const double time = 30 * 86400.0 + i / 60.0;
        frames.push_back(waves.at(0, time));
        const Maps& now = frames.back();
        EXPECT_LT(tests::waveError(tests::waveTruth(*sea, 0, time), now.displacement, now.derivatives).worst,
                  1e-3 * height);
        if (i < 2) continue;
        const Maps &before = frames[static_cast<size_t>(i) - 1],
                   &earlier = frames[static_cast<size_t>(i) - 2];
        double moved = 0, jumped = 0;
        for (size_t t = 0; t < now.texels(); ++t) {
            moved = std::max(moved, std::abs(now.height(t) - before.height(t)));
            jumped = std::max(jumped, std::abs(now.height(t) - 2 * before.height(t) + earlier.height(t)));
        }
        EXPECT_GT(moved, 1e-3 * height);
        EXPECT_LT(jumped, 0.2 * moved);
    }
}

TEST(WavesFftw, SameBitsWhereverTheMapsLie) {
    const auto sea = makeSea(tests::oneCascade());
    const Maps expected = Waves(*sea).at(0, 9);
    const size_t floats = 4 * expected.texels();
    std::vector<float> memory(3 * floats + 3);
    void* state = fftwWaves()->create(*sea);
    float* start = memory.data() + 1;
    fftwWaves()->evaluate(state, 0, 9, {start, start + floats + 1, start + 2 * floats + 2});
    fftwWaves()->destroy(state);
    EXPECT_TRUE(std::equal(expected.displacement.begin(), expected.displacement.end(), start));
    EXPECT_TRUE(std::equal(expected.derivatives.begin(), expected.derivatives.end(), start + floats + 1));
    EXPECT_TRUE(std::equal(expected.moments.begin(), expected.moments.end(), start + 2 * floats + 2));
}

TEST(WavesFftw, ReturnsNullWhenOutOfMemory) {
    const auto sea = makeSea(tests::oneCascade());
    bool made = false;
    for (int allocations = 0; !made; ++allocations) {
        ASSERT_LT(allocations, 100);
        void* state = nullptr;
        {
            const tests::Starved starved(allocations);
            state = fftwWaves()->create(*sea);
        }
        made = state != nullptr;
        if (made) fftwWaves()->destroy(state);
        EXPECT_TRUE(made || allocations < 10);
    }
}

TEST(WavesFftw, HasAStateForAFlatSea) {
    SeaDesc desc;
    desc.windSpeed = 0;
    const auto sea = makeSea(desc);
    void* state = fftwWaves()->create(*sea);
    EXPECT_NE(state, nullptr);
    fftwWaves()->destroy(state);
}

TEST(WavesFftw, StaysExactForYears) {
    SeaDesc desc = tests::oneCascade();
    desc.loopPeriod = 1000.3;
    const auto sea = makeSea(desc);
    Waves waves(*sea);
    const double tolerance = 1e-4 * significantWaveHeight(*sea);
    for (const double time : {30 * 86400 + 0.1, year + 0.123, 1e9 + 0.7, -year - 0.123}) {
        const Maps maps = waves.at(0, time);
        for (const size_t texel : {size_t{0}, size_t{777}, size_t{4000}}) {
            const double spacing = 512.0 / 64;
            const double u = static_cast<double>(texel % 64) * spacing,
                         v = static_cast<double>(texel / 64) * spacing;
            EXPECT_NEAR(maps.height(texel), directSum(*sea, 0, time, u, v).h, tolerance) << time;
        }
    }
    desc.loopPeriod = 4096;
    const auto looping = makeSea(desc);
    Waves loop(*looping);
    EXPECT_EQ(loop.at(0, 12.5), loop.at(0, 12.5 + 4096 * 8000.0));
    EXPECT_EQ(loop.at(0, 12.5), loop.at(0, 12.5 - 4096));
    EXPECT_NE(loop.at(0, 12.5), loop.at(0, 12.5 + 2048));
}

} // namespace
