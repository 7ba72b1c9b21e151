// What whitecaps look like, in figures that others have measured at sea, each printed beside the published
// one: lengths and directions by Korinenko, Malinovsky and Kudryavtsev 2018 (Physical Oceanography 25), from
// 10 to 16 m/s; width to length of what breaks by Korinenko et al. 2024; decay by Monahan and Zietlow 1969
// and by Callaghan et al. 2012.
#include "tests/unit/sea/sea_support.h"
#include "water/foam/foam_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// The sea of one time, as its breaking cascades make it.
class Snapshot {
  public:
    Snapshot(const Sea& sea, double time) : sea_(sea), breaking_(breakingOf(sea, {})) {
        tests::Waves waves(sea);
        for (uint32_t c = 0; c < breaking_.count; ++c) maps_.push_back(waves.at(c, time));
    }

    bool breaks(double u, double v) const {
        return sum(u, v, [&](const tests::Maps& m, size_t i) {
                   return breaking_.compression(m.derivatives[4 * i + 2], m.derivatives[4 * i + 3],
                                                m.displacement[4 * i + 3]);
               }) > static_cast<double>(breaking_.now);
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
        for (uint32_t c = 0; c < breaking_.count; ++c)
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
    desc.cascades = 2;
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
    for (const float wind : {10.0f, 13.0f, 16.0f}) {
        const std::vector<Breaker> breakers = breakersAt(wind);
        size_t count = 0;
        const double exponent = exponentOf(breakers, 4, &count);
        double ratio = 0, withWind = 0, longest = 0;
        for (const Breaker& b : breakers) {
            ratio += b.width / b.length / static_cast<double>(breakers.size());
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
    desc.cascades = 2;
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

// Of what is thick, each place by itself: some is broken into again, some is thin and soon gone.
TEST(WhitecapShapes, FoamLastsAsLongAsAtSea) {
    SeaDesc desc;
    desc.windSpeed = 13;
    desc.cascades = 2;
    const auto sea = makeSea(desc);
    const WavesBackend& backend = tests::builtBackend();
    const std::unique_ptr<void, void (*)(void*)> state(backend.create(*sea), backend.destroy);
    FoamHistory foam(*sea, {});
    constexpr size_t places = 100 * 100;
    struct Place {
        double most = 0;
        int since = -1; ///< steps
    };
    std::vector<Place> of(places);
    std::vector<double> lasted;
    for (int64_t step = 400; step < 400 + 30 * static_cast<int64_t>(foamStepsPerSecond); ++step) {
        foam.advance(backend, state.get(), step);
        for (size_t i = 0; i < places; ++i) {
            double thick = 1;
            for (uint32_t c = 0; c < foam.breaking().count; ++c)
                thick *= between(cascade(*sea, c), 4.0 * static_cast<double>(i % 100),
                                 4.0 * static_cast<double>(i / 100),
                                 [&](size_t texel) { return foam.at(c)[texel]; });
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

} // namespace
