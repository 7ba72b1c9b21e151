// Heights at any point and time: the sum over every mode, in double.
//
// On the lattice e^{ik.x} is a product of one factor a column and one a row, so that a point costs a few
// multiplications a mode and no sine. The point of the calm plane that the horizontal displacement carries to
// the point asked for is found by Newton's method.
#include "water/sea/phase.h"
#include "water/sea/sea.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <new>
#include <numbers>
#include <vector>

namespace seaglass {
namespace {

using Complex = std::complex<double>;

struct Vec2 {
    double u = 0;
    double v = 0;
};

double length(Vec2 a) {
    return std::hypot(a.u, a.v);
}

// A sum kept per lane: its order is fixed, and the compiler may still use vectors.
constexpr size_t lanes = 4;
static_assert(Modes::lanes % lanes == 0);

struct LaneSum {
    std::array<double, lanes> lane{};

    double total() const { return (lane[0] + lane[1]) + (lane[2] + lane[3]); }
};

// A complex number per mode of the half plane.
struct Field {
    std::vector<double> re;
    std::vector<double> im;

    explicit Field(size_t count) : re(count), im(count) {}

    void set(size_t at, Complex value) {
        re[at] = value.real();
        im[at] = value.imag();
    }
};

// One cascade at one time: G = h(k,t)/|k|, and its rate of change.
struct Instant {
    int32_t reach;
    size_t pitch;
    double patch;
    double dk;
    std::vector<double> column;     ///< m
    std::vector<double> waveNumber; ///< |k| [rad/m]
    Field wave;
    Field rate;

    Instant(const Modes& modes, const Cascade& cascade, double loopPeriod, double time)
        : reach(modes.reach), pitch(modes.pitch), patch(cascade.patch),
          dk(2 * std::numbers::pi / cascade.patch), column(modes.pitch), waveNumber(modes.frequency.size()),
          wave(modes.frequency.size()), rate(modes.frequency.size()) {
        for (size_t c = 0; c < pitch; ++c) column[c] = static_cast<double>(c) - reach;
        const uint32_t now = loopPhase(time, loopPeriod);
        const double frequencyStep = 2 * std::numbers::pi / loopPeriod;
        for (size_t at = 0; at < waveNumber.size(); ++at) {
            const bool held = modes.frequency[at] != 0;
            if (!held) continue;
            const double m = column[at % pitch];
            const auto n = static_cast<double>(at / pitch);
            const double k = std::sqrt(m * m + n * n) * dk;
            const double phase = radians(wavePhase(modes.frequency[at], now));
            const Complex turn{std::cos(phase), std::sin(phase)};
            const Complex forward = Complex(modes.forwardRe[at], modes.forwardIm[at]) * turn / k;
            const Complex backward =
                Complex(modes.backwardRe[at], modes.backwardIm[at]) * std::conj(turn) / k;
            waveNumber[at] = k;
            wave.set(at, forward + backward);
            rate.set(at, Complex(0, modes.frequency[at] * frequencyStep) * (forward - backward));
        }
    }
};

// e^{ik.x} for all modes of a cascade, a row at a time.
class Carrier {
  public:
    Carrier(const Instant& instant, Vec2 x)
        : columnRe_(instant.pitch), columnIm_(instant.pitch), re_(instant.pitch), im_(instant.pitch),
          stepV_(std::polar(1.0, instant.dk * x.v)) {
        const Complex stepU = std::polar(1.0, instant.dk * x.u);
        const auto middle = static_cast<size_t>(instant.reach);
        Complex factor = 1;
        for (size_t m = 0; m <= middle; ++m, factor *= stepU) {
            columnRe_[middle + m] = columnRe_[middle - m] = factor.real();
            columnIm_[middle + m] = factor.imag();
            columnIm_[middle - m] = -factor.imag();
        }
    }

    void nextRow() {
        for (size_t c = 0; c < re_.size(); ++c) {
            re_[c] = columnRe_[c] * row_.real() - columnIm_[c] * row_.imag();
            im_[c] = columnRe_[c] * row_.imag() + columnIm_[c] * row_.real();
        }
        row_ *= stepV_;
    }

    const double* re() const { return re_.data(); }
    const double* im() const { return im_.data(); }

  private:
    std::vector<double> columnRe_, columnIm_, re_, im_;
    Complex row_ = 1;
    Complex stepV_;
};

// The horizontal displacement and its gradient.
struct Shift {
    Vec2 d;
    double duDu = 0, duDv = 0, dvDu = 0, dvDv = 0;

    void add(const Shift& other, double share) {
        d = {d.u + share * other.d.u, d.v + share * other.d.v};
        duDu += share * other.duDu;
        duDv += share * other.duDv;
        dvDu += share * other.dvDu;
        dvDv += share * other.dvDv;
    }
    /// Of what is looked up elsewhere: by the chain rule.
    Shift warped(const WarpShift& by) const {
        return {d, duDu + duDu * by.uu + duDv * by.vu, duDv + duDu * by.uv + duDv * by.vv,
                dvDu + dvDu * by.uu + dvDv * by.vu, dvDv + dvDu * by.uv + dvDv * by.vv};
    }
    double jacobian() const { return (1 + duDu) * (1 + dvDv) - duDv * dvDu; }
};

// The displacement is the real field of i k G, so that its gradient is that of -k k^T G.
void addShift(const Instant& instant, Vec2 x, double choppiness, Shift& shift) {
    Carrier carrier(instant, x);
    const double* m = instant.column.data();
    const double scale = 2 * choppiness * instant.dk; // 2: the other half plane
    for (size_t n = 0; n <= static_cast<size_t>(instant.reach); ++n) {
        carrier.nextRow();
        const double* gRe = instant.wave.re.data() + n * instant.pitch;
        const double* gIm = instant.wave.im.data() + n * instant.pitch;
        const double *eRe = carrier.re(), *eIm = carrier.im();
        LaneSum re, im, mRe, mIm, mmRe;
        for (size_t c = 0; c < instant.pitch; c += lanes) {
            for (size_t l = 0; l < lanes; ++l) {
                const double waveRe = gRe[c + l] * eRe[c + l] - gIm[c + l] * eIm[c + l];
                const double waveIm = gRe[c + l] * eIm[c + l] + gIm[c + l] * eRe[c + l];
                const double alongRe = m[c + l] * waveRe;
                re.lane[l] += waveRe;
                im.lane[l] += waveIm;
                mRe.lane[l] += alongRe;
                mIm.lane[l] += m[c + l] * waveIm;
                mmRe.lane[l] += m[c + l] * alongRe;
            }
        }
        const auto row = static_cast<double>(n);
        shift.d.u -= scale * mIm.total();
        shift.d.v -= scale * row * im.total();
        shift.duDu -= scale * instant.dk * mmRe.total();
        shift.duDv -= scale * instant.dk * row * mRe.total();
        shift.dvDv -= scale * instant.dk * row * row * re.total();
    }
    shift.dvDu = shift.duDv;
}

// Height, slope and the velocity of the water particle.
struct Surface {
    double height = 0;
    Vec2 slope;
    Vec2 drift;
    double rise = 0;

    void add(const Surface& other, double share) {
        height += share * other.height;
        slope = {slope.u + share * other.slope.u, slope.v + share * other.slope.v};
        drift = {drift.u + share * other.drift.u, drift.v + share * other.drift.v};
        rise += share * other.rise;
    }
    Surface warped(const WarpShift& by) const {
        Surface turned = *this;
        turned.slope.u += slope.u * by.uu + slope.v * by.vu;
        turned.slope.v += slope.u * by.uv + slope.v * by.vv;
        return turned;
    }
};

void addSurface(const Instant& instant, Vec2 x, double choppiness, Surface& surface) {
    Carrier carrier(instant, x);
    const double* m = instant.column.data();
    for (size_t n = 0; n <= static_cast<size_t>(instant.reach); ++n) {
        carrier.nextRow();
        const size_t at = n * instant.pitch;
        const double *gRe = instant.wave.re.data() + at, *gIm = instant.wave.im.data() + at;
        const double *rRe = instant.rate.re.data() + at, *rIm = instant.rate.im.data() + at;
        const double* k = instant.waveNumber.data() + at;
        const double *eRe = carrier.re(), *eIm = carrier.im();
        LaneSum height, slope, mSlope, drift, mDrift, rise;
        for (size_t c = 0; c < instant.pitch; c += lanes) {
            for (size_t l = 0; l < lanes; ++l) {
                const double heightRe = k[c + l] * (gRe[c + l] * eRe[c + l] - gIm[c + l] * eIm[c + l]);
                const double heightIm = k[c + l] * (gRe[c + l] * eIm[c + l] + gIm[c + l] * eRe[c + l]);
                const double rateRe = rRe[c + l] * eRe[c + l] - rIm[c + l] * eIm[c + l];
                const double rateIm = rRe[c + l] * eIm[c + l] + rIm[c + l] * eRe[c + l];
                height.lane[l] += heightRe;
                slope.lane[l] += heightIm;
                mSlope.lane[l] += m[c + l] * heightIm;
                drift.lane[l] += rateIm;
                mDrift.lane[l] += m[c + l] * rateIm;
                rise.lane[l] += k[c + l] * rateRe;
            }
        }
        const auto row = static_cast<double>(n);
        surface.height += 2 * height.total();
        surface.slope.u -= 2 * instant.dk * mSlope.total();
        surface.slope.v -= 2 * instant.dk * row * slope.total();
        surface.drift.u -= 2 * choppiness * instant.dk * mDrift.total();
        surface.drift.v -= 2 * choppiness * instant.dk * row * drift.total();
        surface.rise += 2 * rise.total();
    }
}

class Heights {
  public:
    Heights(const Sea& sea, double time)
        : choppiness_(sea.desc.choppiness), tolerance_(1e-6 * std::sqrt(sea.variance)), warp_(sea.warp) {
        cascades_.reserve(sea.count);
        for (uint32_t c = 0; c < sea.count; ++c)
            cascades_.emplace_back(sea.modes[c], sea.cascades[c], sea.desc.loopPeriod, time);
        if (!sea.shore) return;
        shore_ = &*sea.shore;
        constexpr double noFoam = 1; // its decay [s]
        signal_ = shore_->signalAt(time, noFoam);
    }

    HeightSample at(Vec2 point) const {
        if (!(std::isfinite(point.u) && std::isfinite(point.v))) return {.folded = 1};
        const Found found = invert(point);
        Surface surface;
        const ShoreWave shore = shoreAt(point, found.offset);
        const WarpShift aside = asideAt(point, found.offset);
        for (size_t c = 0; c < cascades_.size(); ++c) {
            Surface one;
            addSurface(cascades_[c], onTile(point, found.offset, aside, cascades_[c].patch), choppiness_,
                       one);
            surface.add(one.warped(aside), shore_ ? shore.kept[c] : 1);
        }
        surface.add(
            {shore.height, {shore.slope[0], shore.slope[1]}, {shore.drift[0], shore.drift[1]}, shore.rise},
            1);

        HeightSample sample;
        sample.height = static_cast<float>(surface.height);
        setNormal(sample, surface.slope, found.shift);
        sample.velocity[0] = static_cast<float>(surface.drift.u);
        sample.velocity[1] = static_cast<float>(surface.rise);
        sample.velocity[2] = static_cast<float>(surface.drift.v);
        sample.folded = found.crossedFold || !found.settled ? 1 : 0;
        return sample;
    }

  private:
    struct Found {
        Vec2 offset; ///< from the point asked for to where its water rests
        Shift shift; ///< there
        bool settled = false;
        bool crossedFold = false; ///< on the way there: other water may lie over the same point
    };

    // Far from the origin the tile's remainder keeps the digits that the sum would lose.
    static Vec2 onTile(Vec2 point, Vec2 offset, const WarpShift& aside, double patch) {
        return {std::fmod(point.u, patch) + offset.u + aside.u,
                std::fmod(point.v, patch) + offset.v + aside.v};
    }

    WarpShift asideAt(Vec2 point, Vec2 offset) const {
        return warpAt(warp_, point.u + offset.u, point.v + offset.v);
    }

    // What the bed leaves of a cascade changes so slowly that its own slope is left out.
    Shift shiftAt(Vec2 point, Vec2 offset) const {
        const ShoreWave shore = shoreAt(point, offset);
        Shift shift{{shore.move[0], shore.move[1]},
                    shore.stretch[0],
                    shore.stretch[2],
                    shore.stretch[2],
                    shore.stretch[1]};
        const WarpShift aside = asideAt(point, offset);
        for (size_t c = 0; c < cascades_.size(); ++c) {
            Shift one;
            addShift(cascades_[c], onTile(point, offset, aside, cascades_[c].patch), choppiness_, one);
            shift.add(one.warped(aside), shore_ ? shore.kept[c] : 1);
        }
        return shift;
    }

    ShoreWave shoreAt(Vec2 point, Vec2 offset) const {
        return shore_ ? shore_->waveAt(signal_, point.u + offset.u, point.v + offset.v, 0) : ShoreWave{};
    }

    // Seeks offset + d(point + offset) = 0. Where the surface nearly folds Newton's step would fly off: it is
    // held to twice the residual, and past the fold it is half a step of the fixed-point iteration.
    Found invert(Vec2 point) const {
        constexpr int steps = 24;
        constexpr double leastJacobian = 0.05;
        Found found;
        for (int step = 0;; ++step) {
            found.shift = shiftAt(point, found.offset);
            const Shift& s = found.shift;
            const Vec2 residual{found.offset.u + s.d.u, found.offset.v + s.d.v};
            const double jacobian = s.jacobian();
            found.settled = length(residual) <= tolerance_;
            found.crossedFold |= !(jacobian > 0);
            if (found.settled || step == steps) return found;

            Vec2 move{-0.5 * residual.u, -0.5 * residual.v};
            if (jacobian > leastJacobian) {
                move.u = -((1 + s.dvDv) * residual.u - s.duDv * residual.v) / jacobian;
                move.v = -((1 + s.duDu) * residual.v - s.dvDu * residual.u) / jacobian;
                const double excess = length(move) / (2 * length(residual));
                if (excess > 1) move = {move.u / excess, move.v / excess};
            }
            found.offset.u += move.u;
            found.offset.v += move.v;
        }
    }

    // Across the displaced surface's tangents; turned upwards where the surface has overturned.
    static void setNormal(HeightSample& sample, Vec2 slope, const Shift& s) {
        const double side = s.jacobian() < 0 ? -1 : 1;
        const double u = side * (slope.v * s.dvDu - slope.u * (1 + s.dvDv));
        const double v = side * (slope.u * s.duDv - slope.v * (1 + s.duDu));
        const double up = side * s.jacobian();
        const double size = std::sqrt(u * u + up * up + v * v);
        if (!(size > 0)) return;
        sample.normal[0] = static_cast<float>(u / size);
        sample.normal[1] = static_cast<float>(up / size);
        sample.normal[2] = static_cast<float>(v / size);
    }

    double choppiness_;
    double tolerance_;
    const Warp& warp_;
    std::vector<Instant> cascades_;
    const Shore* shore_ = nullptr;
    ShoreSignal signal_;
};

} // namespace

void sampleHeights(const Sea& sea, double time, const double* points, size_t count, HeightSample* out) {
    if (sea.count == 0) {
        std::fill_n(out, count, HeightSample{});
        return;
    }
    if (count == 0) return;
    try {
        const Heights heights(sea, time);
        for (size_t i = 0; i < count; ++i) out[i] = heights.at({points[2 * i], points[2 * i + 1]});
    } catch (const std::bad_alloc&) {
        std::fill_n(out, count, HeightSample{.folded = 1});
    }
}

} // namespace seaglass
