#include "water/foam/foam_history.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace seaglass;
using tests::makeSea;

SeaDesc roughSea() {
    SeaDesc desc;
    desc.windSpeed = 15;
    desc.samples = 64;
    desc.cascades = 2;
    return desc;
}

/// A history with its backend, brought to times as frames ask.
class Foam {
  public:
    explicit Foam(const Sea& sea, const FoamDesc& desc = {})
        : sea_(sea), state_(tests::builtBackend().create(sea)), history(sea, desc) {}
    Foam(const Foam&) = delete;
    Foam& operator=(const Foam&) = delete;
    ~Foam() { tests::builtBackend().destroy(state_); }

    /// Foam at `time` as it is drawn, cascade after cascade.
    std::vector<float> at(double time) {
        const FoamTime now = foamTimeOf(time, description(sea_).loopPeriod);
        history.advance(tests::builtBackend(), state_, now.step);
        std::vector<float> drawn;
        for (uint32_t c = 0; c < history.breaking().count; ++c)
            for (size_t i = 0; i < history.at(c).size(); ++i)
                drawn.push_back(history.at(c)[i] + (history.after(c)[i] - history.at(c)[i]) * now.past);
        return drawn;
    }

  private:
    const Sea& sea_;
    void* state_;

  public:
    FoamHistory history;
};

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float v : values) sum += static_cast<double>(v);
    return sum / static_cast<double>(values.size());
}

TEST(FoamHistory, IsTheSameAtAnyFrameRate) {
    const auto sea = makeSea(roughSea());
    constexpr double start = 500, end = start + 4;
    std::vector<float> first;
    for (const double rate : {15.0, 30.0, 60.0, 144.0}) {
        Foam foam(*sea);
        std::vector<float> drawn;
        for (int frame = 0; frame <= static_cast<int>(4 * rate); ++frame)
            drawn = foam.at(start + frame / rate);
        EXPECT_EQ(drawn, foam.at(end)) << rate;
        if (first.empty()) first = drawn;
        EXPECT_EQ(drawn, first) << rate << " frames a second";
    }
    EXPECT_GT(mean(first), 0.003);
}

TEST(FoamHistory, HasNoBeginning) {
    const auto sea = makeSea(roughSea());
    Foam old(*sea), fresh(*sea);
    for (double time = 0; time < 30; time += 0.3) old.at(time);
    EXPECT_EQ(old.at(30.2), fresh.at(30.2));
}

TEST(FoamHistory, JumpsAndTimeRunningBackwardsStartAnew) {
    const auto sea = makeSea(roughSea());
    Foam foam(*sea), other(*sea);
    const std::vector<float> first = foam.at(100);
    EXPECT_NE(foam.at(1e6), first);
    EXPECT_EQ(foam.at(100), first);
    foam.at(101);
    EXPECT_EQ(foam.at(100), other.at(100));
    for (const double time : {-1e5, 1e15, 1e300, -1e300})
        EXPECT_TRUE(std::ranges::all_of(foam.at(time), [](float f) { return f >= 0 && f <= 1; })) << time;
}

// A frame takes as long as what it computes, and the next one has that to catch up.
TEST(FoamHistory, SlowFramesDoNotFeedOnThemselves) {
    const FoamFading fading = fadingOf({});
    for (const double secondsAStep : {0.0, 0.01, 0.1, 0.2, 0.3, 1.0, 20.0})
        for (const double secondsAFrame : {0.016, 0.5, 4.0, 60.0}) {
            FoamKnown known;
            double time = 7;
            for (int frame = 0; frame < 60; ++frame) {
                const int64_t step = foamTimeOf(time, 4096).step;
                const FoamSteps steps = stepsUntil(known, step, fading);
                // One that is late by little after one that was not is made up for.
                if (frame > 0) {
                    EXPECT_LE(steps.count, mostFoamSteps + 2)
                        << secondsAStep << ' ' << secondsAFrame << ' ' << frame;
                }
                known = {steps.last, steps.caughtUp};
                time += secondsAFrame + secondsAStep * static_cast<double>(steps.count);
            }
        }
}

TEST(FoamHistory, StepsThatAreLeftOutStillFade) {
    const FoamFading fading = fadingOf({});
    for (const int64_t late : {1, 2, 8, 9, 10, 23, 50, 51, 52, 1000}) {
        const FoamSteps steps = stepsUntil({500, true}, 500 + late - 1, fading);
        EXPECT_EQ(steps.count, std::min(late, mostFoamSteps));
        EXPECT_EQ(steps.at(steps.count), 500 + late);
        EXPECT_EQ(steps.anew, late > fading.steps);
        EXPECT_EQ(steps.at(0), steps.anew ? 500 + late - fading.steps - 1 : 500);
        int64_t faded = 0;
        for (int64_t i = 1; i <= steps.count; ++i) {
            EXPECT_GE(steps.fadings(i), 1);
            EXPECT_LE(steps.fadings(i), (fading.steps + 6) / 7);
            faded += steps.fadings(i);
        }
        EXPECT_EQ(steps.fadings(steps.count), 1) << "the image holds a step and the one after it";
        EXPECT_EQ(faded, steps.last - steps.at(0));
    }
}

// The first call has a lifetime to catch up, so that a late one after it takes fewer steps: nearly as much
// foam, and all of it a lifetime later.
TEST(FoamHistory, AfterALateFrameIsSoonAsEver) {
    const auto sea = makeSea(roughSea());
    Foam late(*sea), exact(*sea);
    late.at(100);
    const std::vector<float> few = late.at(107), all = exact.at(107);
    EXPECT_NE(few, all);
    EXPECT_NEAR(mean(few), mean(all), 0.4 * mean(all));
    for (double time = 107.5; time < 121; time += 0.5) late.at(time);
    EXPECT_EQ(late.at(121), Foam(*sea).at(121));
}

TEST(FoamHistory, StepsLieAtWholeMultiplesWhateverTheFrame) {
    for (const double time : {0.0, 0.1, 12.3, 86400.0 * 365, -3.21}) {
        const FoamTime at = foamTimeOf(time, 4096);
        EXPECT_NEAR((static_cast<double>(at.step) + static_cast<double>(at.past)) / foamStepsPerSecond, time,
                    1e-6);
        EXPECT_GE(at.past, 0);
        EXPECT_LE(at.past, 1);
    }
}

TEST(FoamHistory, WhatBreaksIsWhiteAndTheRestIsWhatWasThereFaded) {
    const auto sea = makeSea(roughSea());
    Foam foam(*sea);
    tests::Waves waves(*sea);
    const double time = 40;
    foam.at(time);
    const Breaking& breaking = foam.history.breaking();
    const FoamFadings fadings = fadingsOf({}, breaking);
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const tests::Maps maps = waves.at(c, time + 1 / foamStepsPerSecond);
        const float threshold = breaking.threshold[c], softness = breaking.softness[c];
        size_t white = 0;
        for (size_t i = 0; i < maps.texels(); ++i) {
            const float before = foam.history.at(c)[i], after = foam.history.after(c)[i];
            const float compression = breaking.compression(
                maps.derivatives[4 * i + 2], maps.derivatives[4 * i + 3], maps.displacement[4 * i + 3]);
            if (compression > threshold + softness) {
                ++white;
                EXPECT_NEAR(after, 1, 1e-5);
            }
            if (compression < threshold) {
                const float faded = (before + fadings[c].floor) * fadings[c].fade - fadings[c].floor;
                EXPECT_NEAR(after, std::max(faded, 0.0f), 1e-5);
            }
        }
        EXPECT_GT(white, 0u);
        EXPECT_LT(white, maps.texels() / 5);
    }
}

// Whatever its share, a cascade's foam ends as soon as the others', and all fade as one would alone.
TEST(FoamHistory, SharesFadeTogetherAsOne) {
    const FoamDesc desc;
    const FoamFading parts[] = {fadingOf(desc, 0.3f), fadingOf(desc, 0.7f)};
    double foam[] = {1, 1}, seconds = 0;
    while (foam[0] * foam[1] > std::exp(-1.0)) {
        for (int i = 0; i < 2; ++i) {
            const double floor = parts[i].floor;
            foam[i] = (foam[i] + floor) * static_cast<double>(parts[i].fade) - floor;
        }
        seconds += 1 / foamStepsPerSecond;
    }
    EXPECT_NEAR(seconds, static_cast<double>(desc.decayTime), 0.25 * static_cast<double>(desc.decayTime));
    EXPECT_EQ(parts[0].steps, parts[1].steps);
}

TEST(FoamHistory, FoamFadesWithTimeAndDies) {
    for (const float decayTime : {0.5f, 3.85f, 20.0f}) {
        const FoamFading fading = fadingOf({.decayTime = decayTime});
        const auto end = static_cast<double>(fading.floor);
        double foam = 1, seconds = 0;
        double e = 0;
        for (int64_t step = 0; step < fading.steps; ++step) {
            foam = (foam + end) * static_cast<double>(fading.fade) - end;
            seconds += 1 / foamStepsPerSecond;
            if (e == 0 && (foam + end) / (1 + end) <= std::exp(-1.0)) e = seconds;
        }
        EXPECT_LE(foam, 0) << decayTime;
        EXPECT_NEAR(e, static_cast<double>(decayTime), 1.5 / foamStepsPerSecond);
    }
}

// In half floats, as the GPU keeps it, nothing may stick.
TEST(FoamHistory, HalfFloatsFadeToo) {
    constexpr float step = 0x1p-11f; // of halves in 0.5..1
    for (const float share : {0.1f, 1.0f}) {
        const FoamFading slowest = fadingOf({.decayTime = 20}, share);
        for (float foam = 0; foam <= 1; foam += step) {
            const float faded = (foam + slowest.floor) * slowest.fade - slowest.floor;
            const float spacing = foam >= 0.5f     ? step
                                  : foam >= 0.25f  ? step / 2
                                  : foam >= 0.125f ? step / 4
                                                   : step / 8;
            EXPECT_LT(faded, foam - spacing / 2) << foam;
        }
    }
}

} // namespace
