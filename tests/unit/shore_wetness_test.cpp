// What waves leave wet on a beach, against the water's edge looked up at every time before.
#include "seaglass/shore.h"
#include "tests/unit/sea/sea_support.h"
#include "water/sea/smoothstep.h"
#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

using namespace seaglass;
using namespace tests;

namespace {

constexpr double slope = 1.0 / 21, dryingTime = 45;
constexpr double noEye[2] = {0, 0};

/// Swell that runs up a plane; the water's edge is at v = 0.
SeaPtr beach(double height = 1.6, double period = 9) {
    const auto towards = static_cast<float>(72 * std::numbers::pi / 180);
    return beachOf({static_cast<float>(height), static_cast<float>(period), towards, 0.1f, 30}, slope, 260);
}

/// One time of it.
class Wetting {
  public:
    Wetting(const Sea& sea, double time) : sea_(sea), rows_(size_t{4} * shoreRowCount(sea, dryingTime)) {
        block_ = shoreRows(sea, time, dryingTime, noEye, rows_.data());
    }
    ShoreWetness at(double v) const { return shoreWetness(sea_, block_, rows_.data(), 3, v, slope * v); }

  private:
    const Sea& sea_;
    std::vector<float> rows_;
    ShoreBlock block_;
};

/// How deep water stands there [m]; less than nothing where none does.
double waterAt(const Sea& sea, const ShoreSignal& signal, double v) {
    const ShoreWave wave = sea.shore->waveAt(signal, 3, v, 0);
    return wave.height + wave.depth;
}

TEST(ShoreWetness, SwashHangsTogetherWithTheSea) {
    const SeaPtr sea = beach();
    size_t swash = 0, apart = 0;
    double farthest = 0;
    for (double time = 0; time < 90; time += 0.5) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3);
        bool joined = true;
        for (double v = -3; v < 20; v += 0.25) {
            const double water = waterAt(*sea, signal, v);
            if (v > 0 && water > 0.01) {
                ++swash;
                apart += joined ? 0 : 1;
                farthest = std::max(farthest, v);
            }
            joined &= water > 0;
        }
    }
    std::printf("%zu of %zu places of the swash are cut off from the sea; it runs up %.1f m\n", apart, swash,
                farthest);
    EXPECT_GT(farthest, 5);
    EXPECT_LT(static_cast<double>(apart), 0.05 * static_cast<double>(swash));
}

TEST(ShoreWetness, NoWaterRunsOverSandThatLooksDry) {
    const SeaPtr sea = beach();
    size_t under = 0, dry = 0, filmed = 0, bare = 0, unsaid = 0;
    for (double time = 3; time < 63; time += 0.37) {
        const ShoreSignal signal = sea->shore->signalAt(time, 3);
        const Wetting wetting(*sea, time);
        for (double v = -2; v < 20; v += 0.2) {
            const ShoreWave wave = sea->shore->waveAt(signal, 3, v, 0);
            const double water = wave.height + wave.depth;
            const ShoreWetness wetness = wetting.at(v);
            if (wave.wetTo + wave.depth > 1e-3) {
                ++filmed;
                bare += wetness.wet < 0.999 ? 1 : 0;
            }
            if (water > 1e-3) {
                ++under;
                dry += wetness.wet < 0.999 ? 1 : 0;
            }
            unsaid += water > 0.03 && wetness.under < 0.999 ? 1 : 0;
        }
    }
    std::printf(
        "%zu places under water, %zu of them dry, %zu as if in the open; %zu under a film, %zu of them dry\n",
        under, dry, unsaid, filmed, bare);
    EXPECT_GT(under, 1000u);
    EXPECT_EQ(dry, 0u);
    EXPECT_GT(filmed, under);
    EXPECT_EQ(bare, 0u);
    EXPECT_EQ(unsaid, 0u);
}

TEST(ShoreWetness, IsThatOfTheLastTimeThatWaterOrFilmStoodThere) {
    const SeaPtr sea = beach();
    const double time = 71.3, step = 0.1;
    std::vector<double> places;
    for (double v = 2; v < 16; v += 0.2) places.push_back(v);
    std::vector<double> last(places.size(), -1e9);
    for (double then = time - dryingTime; then <= time; then += step) {
        const ShoreSignal signal = sea->shore->signalAt(then, 3);
        for (size_t i = 0; i < places.size(); ++i) {
            const ShoreWave wave = sea->shore->waveAt(signal, 3, places[i], 0);
            if (std::max(wave.height, wave.wetTo) + wave.depth > 0) last[i] = then;
        }
    }
    const Wetting wetting(*sea, time);
    double sum = 0;
    size_t some = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        const double expected = 1 - smoothstep(0, 1, (time - last[i]) / dryingTime);
        sum += std::abs(wetting.at(places[i]).wet - expected);
        some += expected > 0.1 && expected < 0.9 ? 1 : 0;
    }
    std::printf("off by %.3f in the mean of %zu places, %zu of them half dry\n", sum / double(places.size()),
                places.size(), some);
    EXPECT_GT(some, 5u);
    EXPECT_LT(sum, 0.05 * static_cast<double>(places.size()));
}

TEST(ShoreWetness, SandDriesInHalfAMinuteToAMinute) {
    const SeaPtr sea = beach();
    constexpr size_t places = 60;
    std::vector<double> soaked(places, -1), times;
    for (double time = 0; time < 160; time += 0.5) {
        const Wetting wetting(*sea, time);
        for (size_t i = 0; i < places; ++i) {
            const double wet = wetting.at(3 + 0.2 * static_cast<double>(i)).wet;
            if (wet > 0.99) soaked[i] = time;
            if (wet > 0.01 || soaked[i] < 0) continue;
            times.push_back(time - soaked[i]);
            soaked[i] = -1;
        }
    }
    ASSERT_FALSE(times.empty());
    std::ranges::sort(times);
    std::printf("%zu times it dried, in %.1f to %.1f s\n", times.size(), times.front(), times.back());
    EXPECT_GT(times.front(), 30);
    EXPECT_LT(times.back(), 60);
}

TEST(ShoreWetness, FollowsTheTimeWithoutAJump) {
    const SeaPtr sea = beach();
    double most = 0;
    for (double time = 40; time < 52; time += 0.07) {
        const Wetting now(*sea, time), next(*sea, time + 0.002);
        for (double v = 0.5; v < 16; v += 0.5) {
            const double change = next.at(v).wet - now.at(v).wet;
            most = std::max(most, -change); // water comes at once and goes slowly
        }
    }
    std::printf("dries by %.4f in 2 ms at most\n", most);
    EXPECT_LT(most, 0.01);
}

TEST(ShoreWetness, IsTheSameFromEveryEye) {
    const SeaPtr sea = beach();
    std::vector<float> rows(size_t{4} * shoreRowCount(*sea, dryingTime));
    const double eye[2] = {-14, 8.5};
    const ShoreBlock here = shoreRows(*sea, 50, dryingTime, noEye, rows.data()),
                     there = shoreRows(*sea, 50, dryingTime, eye, rows.data());
    for (double v = -1; v < 14; v += 0.5) {
        const ShoreWetness a = shoreWetness(*sea, here, rows.data(), 2, v, slope * v),
                           b = shoreWetness(*sea, there, rows.data(), 2 - eye[0], v - eye[1], slope * v);
        EXPECT_NEAR(a.wet, b.wet, 1e-3);
        EXPECT_NEAR(a.under, b.under, 1e-3);
    }
}

TEST(ShoreWetness, IsANumberAtWhatIsNoPlace) {
    const SeaPtr sea = beach();
    std::vector<float> rows(size_t{4} * shoreRowCount(*sea, dryingTime));
    const ShoreBlock block = shoreRows(*sea, 50, dryingTime, noEye, rows.data());
    const double bad[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300};
    for (const double u : bad)
        for (const double v : bad)
            for (const double height : {0.0, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
                const ShoreWetness wetness = shoreWetness(*sea, block, rows.data(), u, v, height);
                EXPECT_TRUE(wetness.wet >= 0 && wetness.wet <= 1) << u << " " << v << " " << height;
                EXPECT_TRUE(wetness.under >= 0 && wetness.under <= 1) << u << " " << v << " " << height;
            }
}

TEST(ShoreWetness, ThereIsNoneWithoutAShore) {
    SeaDesc desc;
    desc.samples = 64;
    const SeaPtr sea = makeSea(desc);
    EXPECT_EQ(shoreRowCount(*sea, dryingTime), 0u);
    float texel = 7;
    EXPECT_FALSE(shoreTexels(*sea, &texel));
    EXPECT_EQ(texel, 7);
    uint32_t samples[2] = {9, 9};
    shoreSamples(*sea, samples);
    EXPECT_EQ(samples[0] + samples[1], 0u);
    const ShoreBlock block = shoreRows(*sea, 3, dryingTime, noEye, &texel);
    EXPECT_EQ(block.rows[2], 0);
    EXPECT_EQ(shoreWetness(*sea, block, &texel, 0, 0, 1).wet, 0);
}

} // namespace
