#include "water/shore/shore.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "water/sea/phase.h"
#include "water/sea/scramble.h"
#include "water/sea/smoothstep.h"
#include "water/shore/surf.h"
#include "water/spectrum/dispersion.h"
#include "water/spectrum/wave_systems.h"

namespace seaglass {
namespace {

constexpr double pi = std::numbers::pi;
constexpr float never = std::numeric_limits<float>::max();
/// On land, and where there is less water, crests run as over so much [m].
constexpr double leastDepth = 0.08;
/// Waves from both sides of the main direction make short crests [rad].
constexpr double fan = 0.28;
/// omega^2 d / g at which trains begin to stand for the sea's long waves, and at which they have taken over.
constexpr double feelsBed = 1.6, guided = 0.6;
/// Foam in the swash follows the crest a seventh of a wave later.
constexpr double lagCosine = 0.64, lagSine = 0.77;

/// The lesser, with a rounded corner.
double limited(double value, double most) {
    if (!(value > 0) || !(most > 0)) return 0;
    const double ratio = value / most;
    return value / std::sqrt(std::sqrt(1 + ratio * ratio * ratio * ratio));
}

/// What a depth does to waves of the peak, tabled over its root.
class Shoaling {
  public:
    Shoaling(double peak, double offshore, double deepest) : scale_((entries - 1) / std::sqrt(deepest)) {
        const double from = groupSpeed(waveNumber(peak, offshore), offshore);
        for (size_t i = 0; i < entries; ++i) {
            const double root = static_cast<double>(i) / scale_;
            const double depth = std::max(root * root, leastDepth), k = waveNumber(peak, depth);
            table_[i] = {k, std::sqrt(from / groupSpeed(k, depth))};
        }
    }
    struct Entry {
        double k, growth;
    };
    Entry at(double depth) const {
        const double x = std::clamp(std::sqrt(std::max(depth, leastDepth)) * scale_, 0.0, entries - 1.001);
        const auto i = static_cast<size_t>(x);
        const double share = x - static_cast<double>(i);
        const Entry &a = table_[i], &b = table_[i + 1];
        return {std::lerp(a.k, b.k, share), std::lerp(a.growth, b.growth, share)};
    }

  private:
    static constexpr size_t entries = 512;
    double scale_;
    std::array<Entry, entries> table_;
};

/// Of the Eikonal equation |grad t| = slowness: Gauss-Seidel in four orders in turn (Zhao 2005).
void sweep(std::vector<float>& time, std::span<const double> speeds, size_t nu, size_t nv, double spacing) {
    const auto relax = [&](size_t i, size_t j) {
        const size_t here = j * nu + i;
        const float u = std::min(i > 0 ? time[here - 1] : never, i + 1 < nu ? time[here + 1] : never);
        const float v = std::min(j > 0 ? time[here - nu] : never, j + 1 < nv ? time[here + nu] : never);
        const double least = std::min(u, v), most = std::max(u, v), step = spacing / speeds[here];
        if (least >= never) return false;
        const double apart = most - least;
        const double reached =
            apart >= step ? least + step : 0.5 * (least + most + std::sqrt(2 * step * step - apart * apart));
        if (!(reached < time[here] - 1e-4)) return false;
        time[here] = static_cast<float>(reached);
        return true;
    };
    constexpr int mostRounds = 32;
    bool changed = true;
    for (int round = 0; round < mostRounds && changed; ++round) {
        changed = false;
        for (int order = 0; order < 4; ++order)
            for (size_t b = 0; b < nv; ++b)
                for (size_t a = 0; a < nu; ++a)
                    changed |= relax(order & 1 ? nu - 1 - a : a, order & 2 ? nv - 1 - b : b);
    }
}

/// 0 <= x < 1.
double uniform(uint64_t salt) {
    return static_cast<double>(scramble(salt) >> 32) * 0x1p-32;
}

/// What comes in over the bed, and how it does so.
struct Incoming {
    std::span<const Cascade> cascades;
    size_t longWaves = 0;  ///< of the cascades, those that trains stand for: with the peak's waves and longer
    double deviation = 0;  ///< of their height offshore [m]
    double choppiness = 1; ///< SeaDesc's
    double peak = 0;       ///< [rad/s]
    double runUp = 0;      ///< [m]
    bool arrives = false;  ///< by trains
};

void countLongWaves(Incoming& sea, double peakK) {
    double variance = 0;
    for (size_t& n = sea.longWaves; n < sea.cascades.size() && (n == 0 || sea.cascades[n].kMin <= peakK); ++n)
        variance += sea.cascades[n].variance;
    sea.deviation = std::sqrt(variance);
}

/// Share of what happens at the water's edge that happens where calm water is so deep, 0..1.
double nearEdge(double depth, double runUp) {
    const double shallows = std::max(depth, 0.0) / std::max(runUp, 1e-9);
    return std::exp(-shallows * shallows);
}

/// Of crests [m/s]. A bore that collapses at the edge runs up in front of itself as water behind a dam that
/// breaks does, at 2 sqrt(g h) (Ritter 1892; Shen and Meyer 1963).
double crestSpeed(double depth, const Incoming& sea, const Shoaling& shoaling) {
    const double rush = 2 * std::sqrt(gravity * sea.runUp) * nearEdge(depth, sea.runUp);
    return std::hypot(sea.peak / shoaling.at(depth).k, rush);
}

/// Amplitudes of the cascades: of long waves what trains have not taken, and of each what the depth carries.
void keepCascades(const Incoming& sea, double taken, double most, ShorePlace& place) {
    for (size_t c = 0; c < sea.cascades.size(); ++c) {
        const double whole = std::sqrt(sea.cascades[c].variance);
        const double left = limited(whole, 0.4 * most) / std::max(whole, 1e-12);
        place.kept[c] = static_cast<float>(c < sea.longWaves ? std::sqrt(1 - taken) * left : left);
        if (place.depth <= 0) place.kept[c] = 0;
    }
}

/// What becomes of it at a place of known depth. How far it moves points there in any axis, at the most [m].
double comeTo(ShorePlace& place, const Incoming& sea, const Shoaling& shoaling) {
    const double depth = double{place.depth}, most = breakingHeight / 4 * std::max(depth, 0.0);
    const double taken =
        sea.arrives ? 1 - smoothstep(guided, feelsBed, sea.peak * sea.peak * depth / gravity) : 0;
    const auto [k, growth] = shoaling.at(depth);
    const double grown = sea.deviation * growth * std::sqrt(taken), height = limited(grown, most);
    place.height = static_cast<float>(height);
    place.breaking =
        static_cast<float>(std::clamp(2.5 * (1 - height / std::max(grown, 1e-9)), 0.0, 1.0) * taken);
    // Orbits are ellipses; crests must not fold.
    const double orbit = height / std::tanh(std::max(k * depth, 0.05));
    place.sideways = static_cast<float>(sea.choppiness * limited(orbit, 0.28 / k) *
                                        smoothstep(0, 1, depth / (2 * sea.runUp + 1e-9)));
    place.swash = sea.arrives ? static_cast<float>(0.35 * sea.runUp * nearEdge(depth, sea.runUp)) : 0.0f;
    keepCascades(sea, taken, most, place);
    const double crest = std::min(highestSurf * height, highestSurfToDepth * std::max(depth, leastDepth));
    return std::max(crest + 2.5 * double{place.swash}, 3.5 * double{place.sideways});
}

/// A train where it is between two rows.
class TrainNow {
  public:
    TrainNow(const ShoreSignal& signal, size_t train, float arrival) : perSecond_(signal.rowsPerSecond) {
        const double row =
            std::clamp(double{arrival * perSecond_ + signal.offset}, 0.0, signal.count - 1.001);
        const auto i = static_cast<size_t>(row);
        share_ = row - static_cast<double>(i);
        rows_ = &signal.rows[train * signal.count + i];
    }
    double value(float ShoreRow::*of) const {
        return std::lerp(double{rows_[0].*of}, double{rows_[1].*of}, share_);
    }
    /// In a second. Rows go back in time.
    double rate(float ShoreRow::*of) const {
        return double{rows_[0].*of - rows_[1].*of} * double{perSecond_};
    }

  private:
    float perSecond_;
    double share_ = 0;
    const ShoreRow* rows_ = nullptr;
};

/// The trains together at a place.
class TrainSum {
  public:
    TrainSum(const Shore& shore, const ShorePlace& here, double width)
        : shore_(shore), here_(here),
          lean_(0.6 * double{here.breaking}), place_{double{here.height}, double{here.depth}, 0, width,
                                                     double{here.breaking}} {}

    /// `slowness`: by how much later its crest arrives, along u and v [s/m].
    void add(const TrainNow& train, const double (&slowness)[2], ShoreWave& wave);
    /// What the sum makes of the surface.
    void shape(double foamFades, ShoreWave& wave) const;

  private:
    void move(const std::complex<double>& now, const std::complex<double>& rate, double sideways,
              const double (&slowness)[2], ShoreWave& wave) const;

    const Shore& shore_;
    const ShorePlace& here_;
    double lean_; ///< of breakers, forwards
    SurfPlace place_;
    std::complex<double> all_, wide_, rise_,
        slope_[2]; // height and sideways; of waves wide enough to be seen
    double swash_ = 0, wet_ = 0, swashRate_ = 0, swashSlope_[2] = {};
};

void TrainSum::add(const TrainNow& train, const double (&slowness)[2], ShoreWave& wave) {
    const double length = std::max(std::hypot(slowness[0], slowness[1]), 1e-4);
    const double seen = 1 - smoothstep(0.15, 0.4, place_.width * length * shore_.peak() / (2 * pi));
    const std::complex<double> now(train.value(&ShoreRow::height), train.value(&ShoreRow::sideways)),
        rate(train.rate(&ShoreRow::height), train.rate(&ShoreRow::sideways));
    all_ += now;
    wide_ += seen * now;
    rise_ += seen * rate;
    place_.wavesPerMetre += length * shore_.peak() / (2 * pi) / shoreTrains;
    swash_ += train.value(&ShoreRow::swash);
    wet_ += train.value(&ShoreRow::wet);
    swashRate_ += train.rate(&ShoreRow::swash);
    for (size_t axis = 0; axis < 2; ++axis) {
        slope_[axis] -= seen * rate * slowness[axis];
        swashSlope_[axis] -= train.rate(&ShoreRow::swash) * slowness[axis];
        wave.advected[axis] += slowness[axis] / length * (lagCosine * now.real() + lagSine * now.imag()) *
                               double{here_.swash} * shore_.carried();
    }
    move(now, rate, double{here_.sideways} * seen / length, slowness, wave);
}

/// Points to the side: so far for each unit of slowness.
void TrainSum::move(const std::complex<double>& now, const std::complex<double>& rate, double sideways,
                    const double (&slowness)[2], ShoreWave& wave) const {
    const double forward = now.imag() + lean_ * now.real(), forwardRate = rate.imag() + lean_ * rate.real();
    for (size_t axis = 0; axis < 2; ++axis) {
        wave.move[axis] += sideways * forward * slowness[axis];
        wave.drift[axis] += sideways * forwardRate * slowness[axis];
        wave.stretch[axis] -= sideways * forwardRate * slowness[axis] * slowness[axis];
    }
    wave.stretch[2] -= sideways * forwardRate * slowness[0] * slowness[1];
}

void TrainSum::shape(double foamFades, ShoreWave& wave) const {
    const Surf surf = surfOf(wide_, place_);
    const auto change = [&](const std::complex<double>& of) {
        return double{here_.height} * (surf.changes[0] * of.real() + surf.changes[1] * of.imag());
    };
    const double amount = double{here_.swash};
    wave.height = double{here_.height} * surf.height + amount * std::max(swash_, lowestSwash);
    wave.rise = change(rise_);
    for (size_t axis = 0; axis < 2; ++axis) wave.slope[axis] = change(slope_[axis]);
    if (swash_ > lowestSwash) {
        wave.rise += amount * swashRate_;
        wave.rushes = amount * swashRate_;
        for (size_t axis = 0; axis < 2; ++axis) wave.slope[axis] += amount * swashSlope_[axis];
    }
    wave.swash = amount;
    wave.wetTo = amount * wet_;
    wave.foam = surfFoam(all_, surf.biphase, place_, foamFades);
}

} // namespace

Shore::Shore(const ShoreDesc& desc, const SeaDesc& sea, const WaveSystem& system,
             std::span<const Cascade> cascades)
    : samples_{desc.samples[0], desc.samples[1]},
      spacing_(double{desc.spacing}), origin_{desc.origin[0], desc.origin[1]}, peak_(system.spectrum.peak),
      places_(size_t{desc.samples[0]} * desc.samples[1]) {
    double deepest = leastDepth * 2;
    for (size_t i = 0; i < places_.size(); ++i) {
        places_[i].depth = -desc.bed[i];
        deepest = std::max(deepest, double{places_[i].depth});
    }
    const double offshore = double{sea.depth};
    Incoming coming = {.cascades = cascades, .choppiness = double{sea.choppiness}, .peak = peak_};
    countLongWaves(coming, waveNumber(peak_, offshore));
    findSlope(4 * coming.deviation);
    // Hunt 1959: tan(beta) sqrt(H L0).
    runUp_ = std::min(slope_ * std::sqrt(4 * coming.deviation * 2 * pi * gravity / (peak_ * peak_)),
                      4 * coming.deviation);
    coming.runUp = runUp_;

    const Shoaling shoaling(peak_, offshore, deepest);
    std::vector<double> speeds(places_.size());
    for (size_t i = 0; i < speeds.size(); ++i)
        speeds[i] = crestSpeed(double{places_[i].depth}, coming, shoaling);
    coming.arrives = true;
    for (uint32_t train = 0; train < shoreTrains; ++train)
        coming.arrives &=
            findArrivals(system.direction + fan * (static_cast<double>(train) - 1), train, speeds);
    if (coming.arrives) drawTrains(sea, system);

    for (ShorePlace& place : places_) {
        reach_ = std::max(reach_, comeTo(place, coming, shoaling));
        if (double{place.depth} > -2 * runUp_)
            for (const float arrival : place.arrival) longest_ = std::max(longest_, double{arrival});
    }
}

/// The median where the sea's edge may come.
void Shore::findSlope(double height) {
    std::vector<double> found;
    for (size_t j = 0; j + 1 < samples_[1]; ++j)
        for (size_t i = 0; i + 1 < samples_[0]; ++i) {
            const double here = double{place(i, j).depth};
            if (std::abs(here) > std::max(0.4 * height, 0.05)) continue;
            found.push_back(
                std::hypot(double{place(i + 1, j).depth} - here, double{place(i, j + 1).depth} - here) /
                spacing_);
        }
    slope_ = 0.05;
    if (found.empty()) return;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    slope_ = std::clamp(*middle, 0.005, 0.3);
}

/// False where no side of the map lets waves of this direction in from deeper water.
bool Shore::findArrivals(double direction, uint32_t train, std::span<const double> speeds) {
    const size_t nu = samples_[0], nv = samples_[1];
    const double towards[2] = {std::cos(direction), std::sin(direction)};
    constexpr double leastInwards = 0.2;
    const auto entering = [&](size_t i, size_t j) {
        return (i == 0 && towards[0] > leastInwards) || (i + 1 == nu && -towards[0] > leastInwards) ||
               (j == 0 && towards[1] > leastInwards) || (j + 1 == nv && -towards[1] > leastInwards);
    };
    double deepest = 0, speed = 0;
    const auto border = [&](auto&& visit) {
        for (size_t j = 0; j < nv; ++j)
            for (size_t i = 0; i < nu; i += j == 0 || j + 1 == nv ? 1 : nu - 1)
                if (entering(i, j)) visit(i, j);
    };
    border([&](size_t i, size_t j) {
        if (double{place(i, j).depth} <= deepest) return;
        deepest = double{place(i, j).depth};
        speed = speeds[j * nu + i];
    });
    if (!(deepest > 0)) return false;
    std::vector<float> time(places_.size(), never);
    double first = 1e30;
    const auto entry = [&](size_t i, size_t j) {
        return spacing_ * (static_cast<double>(i) * towards[0] + static_cast<double>(j) * towards[1]) / speed;
    };
    border([&](size_t i, size_t j) { first = std::min(first, entry(i, j)); });
    border([&](size_t i, size_t j) {
        if (double{place(i, j).depth} >= 0.6 * deepest)
            time[j * nu + i] = static_cast<float>(entry(i, j) - first);
    });
    sweep(time, speeds, nu, nv, spacing_);
    for (size_t i = 0; i < time.size(); ++i) places_[i].arrival[train] = time[i];
    return true;
}

void Shore::drawTrains(const SeaDesc& sea, const WaveSystem& system) {
    constexpr uint32_t count = 7;
    constexpr double lowest = 0.75, highest = 1.45; // of the peak
    for (uint32_t train = 0; train < shoreTrains; ++train) {
        double sum = 0;
        for (uint32_t m = 0; m < count; ++m) {
            const uint64_t salt = sea.seed * 64 + train * count + m;
            const double jitter = uniform(salt);
            const double frequency = peak_ * std::lerp(lowest, highest, (m + jitter) / count);
            // As the loop has them.
            const double step = 2 * pi / sea.loopPeriod;
            const double held = step * frequencyIndex(frequency, sea.loopPeriod);
            const double power = energy(system.spectrum, frequency);
            trains_[train].push_back({held, std::sqrt(power), 2 * pi * uniform(salt + 0x5eed0000u)});
            sum += power;
        }
        // Together the trains have unit variance.
        for (Wave& wave : trains_[train])
            wave.amplitude *= std::sqrt(2 / (shoreTrains * std::max(sum, 1e-30)));
    }
}

Shore::Cell Shore::cellAt(double u, double v) const {
    // What is no number lies at the first sample.
    const auto within = [](double at, double most) { return at > 0 ? std::min(at, most) : 0.0; };
    const double x = within((u - origin_[0]) / spacing_, samples_[0] - 1.0);
    const double y = within((v - origin_[1]) / spacing_, samples_[1] - 1.0);
    const auto i = std::min(static_cast<size_t>(x), size_t{samples_[0]} - 2);
    const auto j = std::min(static_cast<size_t>(y), size_t{samples_[1]} - 2);
    const auto fx = static_cast<float>(x - static_cast<double>(i)),
               fy = static_cast<float>(y - static_cast<double>(j));
    const ShorePlace* const first = &places_[j * samples_[0] + i];
    return {first, first + samples_[0], fx, fy};
}

float Shore::Cell::depth() const {
    return mix([](const ShorePlace& s) { return s.depth; });
}

float Shore::Cell::arrival(size_t train) const {
    return mix([train](const ShorePlace& s) { return s.arrival[train]; });
}

ShorePlace Shore::at(double u, double v) const {
    const Cell cell = cellAt(u, v);
    ShorePlace out;
    out.depth = cell.depth();
    for (size_t t = 0; t < shoreTrains; ++t) out.arrival[t] = cell.arrival(t);
    out.height = cell.mix([](const ShorePlace& s) { return s.height; });
    out.breaking = cell.mix([](const ShorePlace& s) { return s.breaking; });
    out.sideways = cell.mix([](const ShorePlace& s) { return s.sideways; });
    out.swash = cell.mix([](const ShorePlace& s) { return s.swash; });
    for (size_t c = 0; c < maxCascades; ++c)
        out.kept[c] = cell.mix([c](const ShorePlace& s) { return s.kept[c]; });
    return out;
}

// As shoreWave() of shaders/water/shore/shore.glsl.
ShoreWave Shore::waveAt(const ShoreSignal& signal, double u, double v, double width) const {
    const ShorePlace here = at(u, v);
    const Cell alongU = cellAt(u + spacing_, v), alongV = cellAt(u, v + spacing_);
    ShoreWave wave;
    wave.depth = double{here.depth};
    wave.bedSlope[0] = double{here.depth - alongU.depth()} / spacing_;
    wave.bedSlope[1] = double{here.depth - alongV.depth()} / spacing_;
    for (size_t c = 0; c < maxCascades; ++c) wave.kept[c] = double{here.kept[c]};
    if (here.height == 0 && here.swash == 0) return wave;
    TrainSum sum(*this, here, width);
    for (size_t t = 0; t < shoreTrains; ++t)
        sum.add(TrainNow(signal, t, here.arrival[t]),
                {double{alongU.arrival(t) - here.arrival[t]} / spacing_,
                 double{alongV.arrival(t) - here.arrival[t]} / spacing_},
                wave);
    sum.shape(double{signal.foamFades}, wave);
    return wave;
}

} // namespace seaglass
