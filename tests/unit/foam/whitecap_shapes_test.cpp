// What whitecaps look like, in figures that others have measured at sea, each printed beside the published
// one: lengths and directions by Korinenko, Malinovsky and Kudryavtsev 2018 (Physical Oceanography 25), from
// 10 to 16 m/s; width to length of what breaks by Korinenko et al. 2024; decay by Monahan and Zietlow 1969
// and by Callaghan et al. 2012.
#include "tests/unit/sea/sea_support.h"
#include "water/foam/foam_history.h"
#include "water/interface/foam_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using namespace seaglass;
using tests::makeSea;

/// The calm plane's side that is looked at, and its points [m].
constexpr size_t across = 1024;
constexpr double spacing = 1;

/// A map of one cascade between its samples.
template<typename At>
double between(const Cascade& cascade, double u, double v, At&& at) {
    const auto samples = static_cast<double>(cascade.samples);
    const double x = (u / cascade.patch - std::floor(u / cascade.patch)) * samples;
    const double y = (v / cascade.patch - std::floor(v / cascade.patch)) * samples;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto texel = [&](double i, double j) {
        const auto wrapped = [&](double k) { return static_cast<size_t>(k) % cascade.samples; };
        return static_cast<double>(at(wrapped(j) * cascade.samples + wrapped(i)));
    };
    return std::lerp(std::lerp(texel(x0, y0), texel(x0 + 1, y0), x - x0),
                     std::lerp(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), x - x0), y - y0);
}

/// The sea of one time.
class Snapshot {
  public:
    Snapshot(const Sea& sea, double time) : sea_(sea), breaking_(breakingOf(sea, {})) {
        tests::Waves waves(sea);
        for (uint32_t c = 0; c < cascadeCount(sea); ++c) maps_.push_back(waves.at(c, time));
    }

    bool breaks(double u, double v) const {
        double compression = 0;
        for (uint32_t c = 0; c < maps_.size(); ++c)
            compression +=
                static_cast<double>(breaking_.counts[c]) * between(cascade(sea_, c), u, v, [&](size_t i) {
                    const tests::Maps& m = maps_[c];
                    return breaking_.compression(m.derivatives[4 * i + 2], m.derivatives[4 * i + 3],
                                                 m.displacement[4 * i + 3]);
                });
        return compression > static_cast<double>(breaking_.now);
    }
    double height(double u, double v) const {
        return sum(u, v, [](const tests::Maps& m, size_t i) { return m.displacement[4 * i + 1]; });
    }
    /// Where the water of a calm place is, as seen from above.
    std::array<double, 2> seenAt(double u, double v) const {
        return {u + sum(u, v, [](const tests::Maps& m, size_t i) { return m.displacement[4 * i]; }),
                v + sum(u, v, [](const tests::Maps& m, size_t i) { return m.displacement[4 * i + 2]; })};
    }

  private:
    template<typename At>
    double sum(double u, double v, At&& at) const {
        double sum = 0;
        for (uint32_t c = 0; c < maps_.size(); ++c)
            sum += between(cascade(sea_, c), u, v, [&](size_t i) { return at(maps_[c], i); });
        return sum;
    }

    const Sea& sea_;
    Breaking breaking_;
    std::vector<tests::Maps> maps_;
};

struct Breaker {
    double length = 0, width = 0; ///< axes of the ellipse of its moments [m]
    double towards = 0;           ///< of the shorter axis, from +u to +v [rad]
};

/// Sums over the points of one breaker, as seen from above.
struct Moments {
    double count = 0, u = 0, v = 0, uu = 0, vv = 0, uv = 0;

    void add(const std::array<double, 2>& at) {
        count += 1;
        u += at[0], v += at[1];
        uu += at[0] * at[0], vv += at[1] * at[1], uv += at[0] * at[1];
    }
    Breaker breaker() const {
        const double a = uu / count - u * u / (count * count), c = vv / count - v * v / (count * count);
        const double b = uv / count - u * v / (count * count);
        const double middle = (a + c) / 2, half = std::hypot((a - c) / 2, b);
        // A point stands for a square.
        const double own = spacing * spacing / 12;
        return {4 * std::sqrt(middle + half + own), 4 * std::sqrt(std::max(middle - half, 0.0) + own),
                0.5 * std::atan2(2 * b, a - c) + std::numbers::pi / 2};
    }
};

/// What breaks at one time, each patch that hangs together by itself.
std::vector<Breaker> breakersOf(const Snapshot& sea) {
    std::vector<uint8_t> breaks(across * across);
    for (size_t i = 0; i < breaks.size(); ++i)
        breaks[i] =
            sea.breaks(spacing * static_cast<double>(i % across), spacing * static_cast<double>(i / across));
    std::vector<Breaker> found;
    std::vector<size_t> open;
    for (size_t first = 0; first < breaks.size(); ++first) {
        if (!breaks[first]) continue;
        Moments moments;
        breaks[first] = 0;
        open.assign(1, first);
        while (!open.empty()) {
            const size_t i = open.back(), x = i % across, y = i / across;
            open.pop_back();
            moments.add(sea.seenAt(spacing * static_cast<double>(x), spacing * static_cast<double>(y)));
            const auto visit = [&](size_t next) {
                if (breaks[next]) open.push_back(next);
                breaks[next] = 0;
            };
            if (x > 0) visit(i - 1);
            if (x + 1 < across) visit(i + 1);
            if (y > 0) visit(i - across);
            if (y + 1 < across) visit(i + across);
        }
        if (moments.count >= 3) found.push_back(moments.breaker());
    }
    return found;
}

std::vector<Breaker> breakersAt(float wind) {
    SeaDesc desc;
    desc.windSpeed = wind;
    desc.cascades = 3;
    desc.windDirection = 0.6f;
    std::vector<Breaker> all;
    for (uint64_t seed = 1; seed <= 2; ++seed) {
        desc.seed = seed;
        const auto sea = makeSea(desc);
        for (const Breaker& b : breakersOf(Snapshot(*sea, 100 + 37.0 * static_cast<double>(seed))))
            all.push_back(b);
    }
    return all;
}

/// Of a density as length^-exponent from `shortest` on, most likely (Hill 1975).
double exponentOf(const std::vector<Breaker>& breakers, double shortest, size_t* count) {
    double logs = 0;
    *count = 0;
    for (const Breaker& b : breakers)
        if (b.length >= shortest) {
            logs += std::log(b.length / shortest);
            ++*count;
        }
    return 1 + static_cast<double>(*count) / logs;
}

TEST(WhitecapShapes, BreakersAreAsLongAndWideAsAtSea) {
    for (const float wind : {10.0f, 13.0f, 16.0f, 20.0f}) {
        const std::vector<Breaker> breakers = breakersAt(wind);
        size_t count = 0;
        const double exponent = exponentOf(breakers, 4, &count);
        double ratio = 0, withWind = 0, longest = 0;
        for (const Breaker& b : breakers) {
            if (b.length >= 4) ratio += b.width / b.length / static_cast<double>(count);
            const double along = std::cos(b.towards - 0.6);
            withWind += along * along / static_cast<double>(breakers.size());
            longest = std::max(longest, b.length);
        }
        std::printf(
            "%2.0f m/s: %zu breakers, %zu of 4 m and more, longest %.0f m; lengths as L^-%.2f (Korinenko "
            "2018: 3.23); width / length %.2f (Korinenko 2024: 0.41); cos^2 to the wind %.2f (Korinenko "
            "2018: 0.83 to 0.86)\n",
            static_cast<double>(wind), breakers.size(), count, longest, exponent, ratio, withWind);
        EXPECT_GT(count, 100u);
        EXPECT_NEAR(exponent, 3.23, 0.8);
        EXPECT_NEAR(ratio, 0.41, 0.12);
        EXPECT_NEAR(withWind, 0.85, 0.1);
    }
}

TEST(WhitecapShapes, WavesBreakAtTheCrestAndAheadOfIt) {
    SeaDesc desc;
    desc.windSpeed = 13;
    desc.cascades = 3;
    const auto sea = makeSea(desc);
    constexpr double step = 0.05;
    const Snapshot before(*sea, 100 - step), now(*sea, 100), after(*sea, 100 + step);
    const double frequency = peakFrequency(*sea);
    size_t breaking = 0, front = 0, all = 0, frontOfAll = 0;
    for (size_t i = 0; i < across * across; i += 3) {
        const double u = spacing * static_cast<double>(i % across),
                     v = spacing * static_cast<double>(i / across);
        const double rise = (after.height(u, v) - before.height(u, v)) / (2 * step * frequency);
        const double phase = std::atan2(rise, now.height(u, v)); // of the wave: 0 at its crest, before it +
        const bool isFront = phase > -std::numbers::pi / 6 && phase < std::numbers::pi / 2;
        ++all;
        frontOfAll += isFront;
        if (!now.breaks(u, v)) continue;
        ++breaking;
        front += isFront;
    }
    std::printf("%zu points break, %.2f of them in the crest's front third; of all points %.2f\n", breaking,
                static_cast<double>(front) / static_cast<double>(breaking),
                static_cast<double>(frontOfAll) / static_cast<double>(all));
    EXPECT_GT(static_cast<double>(front), 0.75 * static_cast<double>(breaking));
}

SeaDesc seaOf(float wind) {
    SeaDesc desc;
    desc.windSpeed = wind;
    desc.cascades = 3;
    return desc;
}

/// Foam of all cascades together, as it is where the water has drifted to that was at a place at first.
class DriftingFoam {
  public:
    explicit DriftingFoam(float wind)
        : sea_(makeSea(seaOf(wind))),
          state_(tests::builtBackend().create(*sea_), tests::builtBackend().destroy), foam_(*sea_, {}) {}
    /// Where foam has drifted to by then is where places lie from now on.
    void placeAt(int64_t step) {
        for (uint32_t c = 0; c < foam_.breaking().count; ++c)
            drift_[c] = foamDriftOf(description(*sea_), cascade(*sea_, c), foamStepTime(step));
    }
    void goTo(int64_t step) { foam_.advance(tests::builtBackend(), state_.get(), step); }
    double at(double u, double v) const {
        double thick = 1;
        for (uint32_t c = 0; c < foam_.breaking().count; ++c) {
            const double patch = cascade(*sea_, c).patch;
            thick *= between(cascade(*sea_, c), u - patch * drift_[c].u, v - patch * drift_[c].v,
                             [&](size_t texel) { return foam_.band(c).foam[texel]; });
        }
        return thick;
    }

  private:
    tests::SeaPtr sea_;
    std::unique_ptr<void, void (*)(void*)> state_;
    FoamHistory foam_;
    std::array<FoamDrift, maxCascades> drift_{};
};

// Of what is thick, each place by itself: some is broken into again, some is thin and soon gone.
TEST(WhitecapShapes, FoamLastsAsLongAsAtSea) {
    DriftingFoam foam(13);
    constexpr size_t places = 100 * 100;
    struct Place {
        double most = 0;
        int since = -1; ///< steps
    };
    std::vector<Place> of(places);
    std::vector<double> lasted;
    foam.placeAt(400);
    for (int64_t step = 400; step < 400 + 30 * static_cast<int64_t>(foamStepsPerSecond); ++step) {
        foam.goTo(step);
        for (size_t i = 0; i < places; ++i) {
            const double thick =
                foam.at(4.0 * static_cast<double>(i % 100), 4.0 * static_cast<double>(i / 100));
            Place& place = of[i];
            if (thick >= std::max(0.5, place.most)) place = {thick, 0};
            if (place.since < 0) continue;
            if (thick < place.most / std::numbers::e) {
                lasted.push_back(place.since / foamStepsPerSecond);
                place = {};
            } else
                ++place.since;
        }
    }
    std::ranges::sort(lasted);
    const auto at = [&](double share) {
        return lasted[static_cast<size_t>(share * static_cast<double>(lasted.size()))];
    };
    double mean = 0;
    for (const double seconds : lasted) mean += seconds / static_cast<double>(lasted.size());
    std::printf(
        "%zu places: foam fades to 1/e in %.1f s in the mean (Monahan and Zietlow 1969: 3.85), %.1f to %.1f "
        "(Callaghan et al. 2012: 0.5 to 8)\n",
        lasted.size(), mean, at(0.05), at(0.95));
    EXPECT_NEAR(mean, 3.85, 1);
    EXPECT_GT(at(0.05), 0.5);
    EXPECT_LT(at(0.95), 8);
}

/// Foam that hangs together at first.
struct Whitecap {
    std::vector<std::array<double, 2>> places;
    double first = 0;
    double most = 0;    ///< since, of `first`
    double lasted = -1; ///< to 1/e [s]; less than 0: longer than was looked at
};

std::vector<Whitecap> whitecapsOf(const DriftingFoam& foam) {
    constexpr size_t points = 384;
    std::vector<uint8_t> white(points * points);
    const auto placeOf = [](size_t i) {
        return std::array{2.0 * static_cast<double>(i % points), 2.0 * static_cast<double>(i / points)};
    };
    for (size_t i = 0; i < white.size(); ++i) white[i] = foam.at(placeOf(i)[0], placeOf(i)[1]) > 0.3;
    std::vector<Whitecap> found;
    std::vector<size_t> open;
    for (size_t first = 0; first < white.size(); ++first) {
        if (!white[first]) continue;
        Whitecap& cap = found.emplace_back();
        white[first] = 0;
        open.assign(1, first);
        while (!open.empty()) {
            const size_t i = open.back();
            open.pop_back();
            cap.places.push_back(placeOf(i));
            cap.first += foam.at(placeOf(i)[0], placeOf(i)[1]);
            const auto visit = [&](bool within, size_t next) {
                if (within && white[next]) {
                    white[next] = 0;
                    open.push_back(next);
                }
            };
            visit(i % points > 0, i - 1);
            visit(i % points + 1 < points, i + 1);
            visit(i >= points, i - points);
            visit(i + points < white.size(), i + points);
        }
    }
    return found;
}

// Each whitecap by itself, from when it grows no more and as long as nothing breaks into it.
TEST(WhitecapShapes, LargeWhitecapsOutlastSmallOnes) {
    DriftingFoam foam(13);
    std::vector<Whitecap> all;
    for (const int64_t start : {400, 460, 520}) {
        foam.goTo(start);
        foam.placeAt(start);
        std::vector<Whitecap> caps = whitecapsOf(foam);
        for (int64_t step = start + 1; step < start + 40; ++step) {
            foam.goTo(step);
            for (Whitecap& cap : caps) {
                if (cap.lasted >= 0) continue;
                double now = 0;
                for (const auto& [u, v] : cap.places) now += foam.at(u, v);
                cap.most = std::max(cap.most, now / cap.first);
                if (now < cap.first / std::numbers::e)
                    cap.lasted = static_cast<double>(step - start) / foamStepsPerSecond;
            }
        }
        for (Whitecap& cap : caps)
            if (cap.lasted >= 0 && cap.most < 1.02) all.push_back(std::move(cap));
    }
    std::ranges::sort(all, {}, [](const Whitecap& cap) { return cap.places.size(); });
    double lasts[2] = {};
    const size_t fifth = all.size() / 5;
    for (size_t i = 0; i < fifth; ++i) {
        lasts[0] += all[i].lasted / static_cast<double>(fifth);
        lasts[1] += all[all.size() - 1 - i].lasted / static_cast<double>(fifth);
    }
    std::printf(
        "%zu whitecaps: to 1/e in %.1f s the smallest fifth, up to %.0f m2, in %.1f s the largest, from %.0f "
        "m2 on: a ratio of %.1f (Callaghan et al. 2012: up to 3 to 4)\n",
        all.size(), lasts[0], 4.0 * static_cast<double>(all[fifth].places.size()), lasts[1],
        4.0 * static_cast<double>(all[all.size() - fifth].places.size()), lasts[1] / lasts[0]);
    EXPECT_GT(all.size(), 40u);
    EXPECT_GT(lasts[1], 1.3 * lasts[0]);
    EXPECT_LT(lasts[1], 4 * lasts[0]);
}

} // namespace
