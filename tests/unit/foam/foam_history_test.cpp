#include "water/foam/foam_history.h"

#include "tests/unit/sea/sea_support.h"
#include "water/interface/foam_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
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
        for (uint32_t c = 0; c < history.breaking().count; ++c) {
            const FoamHistory::Band& band = history.band(c);
            for (size_t i = 0; i < band.foam.size(); ++i)
                drawn.push_back(std::lerp(band.foam[i], band.foamNext[i], now.past));
        }
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
                EXPECT_LE(steps.all(), fading.foam.steps + fading.plume.steps + 2);
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
        EXPECT_EQ(steps.at(steps.all() - 1).step, 500 + late);
        EXPECT_EQ(steps.anew, late > fading.foam.steps);
        EXPECT_EQ(steps.before, steps.anew ? 500 + late - fading.foam.steps - 1 : 500);
        int64_t faded = 0;
        for (int64_t i = steps.plumesAlone; i < steps.all(); ++i) {
            EXPECT_GE(steps.at(i).fadings, 1);
            EXPECT_LE(steps.at(i).fadings, (fading.foam.steps + 6) / 7);
            faded += steps.at(i).fadings;
        }
        EXPECT_EQ(steps.at(steps.all() - 1).fadings, 1) << "the image holds a step and the one after it";
        EXPECT_EQ(faded, steps.last - steps.before);
    }
}

// Whatever the frames, a second's plumes are made of the sea as it is on the second.
TEST(FoamHistory, PlumesAreSteppedOnceASecond) {
    const FoamFading fading = fadingOf({});
    for (const int64_t step : {-9, -4, 0, 399, 400, 401, 402}) {
        const FoamSteps anew = stepsUntil({}, step, fading);
        int64_t plumes = 0;
        for (int64_t i = 0; i < anew.all(); ++i) {
            const FoamStep at = anew.at(i);
            EXPECT_EQ(at.plumeAnew, i == 0);
            EXPECT_EQ(at.plumeFadings > 0, at.step % foamStepsPerPlume == 0) << at.step;
            plumes += at.plumeFadings;
        }
        EXPECT_EQ(plumes, fading.plume.steps + 1);
        EXPECT_EQ(stepsUntil({step, false}, step, fading).at(0).plumeFadings,
                  (step + 1) % foamStepsPerPlume == 0);
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

/// Compression of a cascade where a sample of its drifting foam lies.
double compressionAt(const tests::Maps& maps, const Sea& sea, const Breaking& breaking, uint32_t c,
                     double time, size_t i) {
    const Cascade& cascade = seaglass::cascade(sea, c);
    const FoamDrift drift = foamDriftOf(description(sea), cascade, time);
    const double samples = cascade.samples, u = static_cast<double>(i % cascade.samples) + samples * drift.u,
                 v = static_cast<double>(i / cascade.samples) + samples * drift.v;
    double sum = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = std::floor(u) + corner % 2, y = std::floor(v) + corner / 2;
        const auto wrapped = [&](double k) { return static_cast<size_t>(k) % cascade.samples; };
        const size_t at = wrapped(y) * cascade.samples + wrapped(x);
        sum += (1 - std::abs(u - x)) * (1 - std::abs(v - y)) *
               double{breaking.compression(maps.derivatives[4 * at + 2], maps.derivatives[4 * at + 3],
                                           maps.displacement[4 * at + 3])};
    }
    return sum;
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
        const double next = time + 1 / foamStepsPerSecond;
        const tests::Maps maps = waves.at(c, next);
        const double threshold = breaking.threshold[c], softness = breaking.softness[c];
        size_t white = 0;
        for (size_t i = 0; i < maps.texels(); ++i) {
            const float before = foam.history.band(c).foam[i], after = foam.history.band(c).foamNext[i];
            const double compression = compressionAt(maps, *sea, breaking, c, next, i);
            if (compression > threshold + softness + 1e-5) {
                ++white;
                EXPECT_NEAR(after, 1, 1e-5);
            }
            if (compression < threshold) {
                EXPECT_NEAR(after, fadedFoam(before, fadings[c].foam.fade, fadings[c].foam.floor), 1e-4);
            }
        }
        EXPECT_GT(white, 0u);
        EXPECT_LT(white, maps.texels() / 5);
    }
}

// Whatever its share, a cascade's foam ends as soon as the others', and the odds of all fade as one's would
// alone.
TEST(FoamHistory, SharesFadeTogetherAsOne) {
    const FoamDesc desc;
    const Fading parts[] = {fadingOf(desc, 0.3f).foam, fadingOf(desc, 0.7f).foam};
    double odds[] = {double{foamMostOdds}, double{foamMostOdds}}, seconds = 0;
    const double end = odds[0] * odds[1] * std::exp(-1.0);
    while (odds[0] * odds[1] > end) {
        for (int i = 0; i < 2; ++i) {
            const double floor = parts[i].floor;
            odds[i] = (odds[i] + floor) * static_cast<double>(parts[i].fade) - floor;
        }
        seconds += 1 / foamStepsPerSecond;
    }
    EXPECT_NEAR(seconds, oddsDecayTime(desc), 0.25 * oddsDecayTime(desc));
    EXPECT_EQ(parts[0].steps, parts[1].steps);
}

// Foam that broke strongly, which is wide, is white for longer (Callaghan et al. 2012: up to 3 or 4 times).
TEST(FoamHistory, FoamFadesWithTimeAndDies) {
    for (const float decayTime : {0.5f, 3.85f, 20.0f}) {
        const Fading fading = fadingOf({.decayTime = decayTime}).foam;
        double lasts[2] = {};
        for (int strong = 0; strong < 2; ++strong) {
            const float first = strong != 0 ? 1.0f : 0.2f;
            float foam = first;
            for (int64_t step = 0; step < fading.steps; ++step) {
                if (foam * std::exp(1.0f) > first) lasts[strong] += 1 / foamStepsPerSecond;
                foam = fadedFoam(foam, fading.fade, fading.floor);
            }
            EXPECT_EQ(foam, 0) << decayTime;
        }
        std::printf(
            "decay time %4.1f s: to 1/e in %.2f s where full, %.2f s where thin, a ratio of %.1f (Callaghan "
            "et al. 2012: 3 to 4)\n",
            double{decayTime}, lasts[1], lasts[0], lasts[1] / lasts[0]);
        EXPECT_GT(lasts[1], 2 * lasts[0]);
        EXPECT_LT(lasts[1], 4.5 * lasts[0]);
    }
}

TEST(FoamHistory, PlumesOutlastFoamByTensOfSeconds) {
    const Fading plume = fadingOf({}).plume;
    float bubbles = 1;
    int64_t third = 0;
    for (int64_t step = 0; step < plume.steps; ++step) {
        if (bubbles > std::exp(-1.0f)) ++third;
        bubbles = fadedPlume(bubbles, plume.fade, plume.floor);
    }
    EXPECT_EQ(bubbles, 0);
    const double seconds = static_cast<double>(third * foamStepsPerPlume) / foamStepsPerSecond;
    std::printf("plumes fade to 1/e in %.0f s, and are gone after %.0f\n", seconds,
                static_cast<double>(plume.steps));
    EXPECT_GT(seconds, 8);
    EXPECT_GT(plume.steps, 20);
}

// In half floats, as the GPU keeps it, nothing may stick.
TEST(FoamHistory, HalfFloatsFadeToo) {
    constexpr float step = 0x1p-11f; // of halves in 0.5..1
    for (const float share : {0.1f, 1.0f}) {
        const FoamFading slowest = fadingOf({.decayTime = 20}, share);
        for (float held = 0; held <= 1; held += step) {
            const float spacing = held >= 0.5f     ? step
                                  : held >= 0.25f  ? step / 2
                                  : held >= 0.125f ? step / 4
                                                   : step / 8;
            const float white = 1 - held; // of foam it keeps what is clear
            EXPECT_LT(fadedFoam(white, slowest.foam.fade, slowest.foam.floor),
                      std::max(white - spacing / 2, 1e-9f))
                << white;
            EXPECT_LT(fadedPlume(held, slowest.plume.fade, slowest.plume.floor),
                      std::max(held - spacing / 2, 1e-9f))
                << held;
        }
    }
}

// A patch of foam a while later lies where the current has carried it: downwind, by 0.035 of the wind (Wu
// 1975).
TEST(FoamHistory, PatchesDriftWithTheWater) {
    SeaDesc desc = roughSea();
    desc.windDirection = 0.7f;
    const auto sea = makeSea(desc);
    constexpr double start = 300, later = 4;
    for (uint32_t c = 0; c < cascadeCount(*sea); ++c) {
        const Cascade& of = cascade(*sea, c);
        const FoamDrift from = foamDriftOf(desc, of, start), to = foamDriftOf(desc, of, start + later);
        const auto metres = [&](double tiles) { return of.patch * (tiles - std::round(tiles)); };
        const double u = metres(to.u - from.u), v = metres(to.v - from.v);
        const double speed = std::hypot(u, v) / later;
        std::printf("cascade %u: drifts at %.4f of the wind (Wu 1975: 0.035), %.1f degrees off it\n", c,
                    speed / double{desc.windSpeed}, (std::atan2(v, u) - 0.7) * 57.3);
        EXPECT_NEAR(speed / double{desc.windSpeed}, 0.035, 0.002);
        EXPECT_NEAR(std::atan2(v, u), 0.7, 0.06);
    }
}

/// Foam of a cascade at a place [m].
double foamOf(const FoamHistory& history, const Sea& sea, uint32_t c, double time, double u, double v) {
    const Cascade& of = cascade(sea, c);
    const FoamDrift drift = foamDriftOf(description(sea), of, time);
    const auto sample = [&](double metres, double drifted) {
        const double tiles = metres / of.patch - drifted;
        return static_cast<size_t>((tiles - std::floor(tiles)) * of.samples) % of.samples;
    };
    return history.band(c).foam[sample(v, drift.v) * of.samples + sample(u, drift.u)];
}

// Not the drift that is stated but foam itself: it is most like what was there where the current carried it.
TEST(FoamHistory, FoamIsFoundWhereItHasDrifted) {
    SeaDesc desc = roughSea();
    desc.windSpeed = 20;
    desc.samples = 128;
    desc.largestPatch = 200;
    const auto sea = makeSea(desc);
    Foam foam(*sea);
    constexpr double start = 300, later = 3;
    constexpr int across = 200;
    std::vector<double> before;
    foam.at(start);
    for (int i = 0; i < across * across; ++i)
        before.push_back(foamOf(foam.history, *sea, 0, start, i % across, i / across));
    foam.at(start + later);
    const auto alike = [&](double aside) {
        double sum = 0;
        for (int i = 0; i < across * across; ++i) {
            const double then = before[static_cast<size_t>(i)],
                         now = foamOf(foam.history, *sea, 0, start + later, i % across + aside, i / across);
            // What has broken since is another's.
            if (then > 0.1 && now < then) sum += now / then;
        }
        return sum;
    };
    const double drifted = 0.035 * 20 * later;
    EXPECT_GT(alike(drifted), 1.05 * alike(0));
    EXPECT_GT(alike(drifted), 1.05 * alike(2 * drifted));
}

} // namespace
