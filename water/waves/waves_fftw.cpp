// The CPU wave backend: one inverse transform in two passes, by FFTW.
//
// Fields and pairs are those of wave_fields.h. The pass along the columns does 0 <= m <= reach alone; that
// along the rows goes row by row through a buffer that fits the first-level cache, straight into the maps.
#include "seaglass/waves_fftw.h"

#include "water/interface/waves_backend.h"
#include "water/sea/phase.h"
#include "water/sea/sea.h"
#include "water/waves/wave_fields.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <latch>
#include <memory>
#include <mutex>
#include <new>
#include <numbers>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace seaglass {
namespace {

constexpr size_t pairs = wavePairs;
constexpr size_t texel = 2 * pairs; ///< floats
constexpr size_t lanes = Modes::lanes;

struct FftwFree {
    void operator()(void* memory) const { fftwf_free(memory); }
};
using FloatBuffer = std::unique_ptr<float[], FftwFree>;

FloatBuffer allocate(size_t floats) {
    FloatBuffer buffer(static_cast<float*>(fftwf_malloc(floats * sizeof(float))));
    if (!buffer) throw std::bad_alloc();
    return buffer;
}

fftwf_complex* complexes(float* memory) {
    return reinterpret_cast<fftwf_complex*>(memory);
}

// FFTW's planner is not thread safe; its execution is.
std::mutex& plannerMutex() {
    static std::mutex mutex;
    return mutex;
}

class Plan {
  public:
    // `count` interleaved inverse transforms in place: element e of transform f at memory[e * stride + f].
    Plan(uint32_t size, size_t count, size_t stride, float* memory) {
        const std::scoped_lock lock(plannerMutex());
        const fftwf_iodim along{static_cast<int>(size), static_cast<int>(stride), static_cast<int>(stride)};
        const fftwf_iodim across{static_cast<int>(count), 1, 1};
        plan_ = fftwf_plan_guru_dft(1, &along, 1, &across, complexes(memory), complexes(memory),
                                    FFTW_BACKWARD, FFTW_ESTIMATE);
        if (!plan_) throw std::bad_alloc();
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    Plan(Plan&& other) noexcept : plan_(std::exchange(other.plan_, nullptr)) {}
    ~Plan() {
        if (!plan_) return;
        const std::scoped_lock lock(plannerMutex());
        fftwf_destroy_plan(plan_);
    }

    void execute(float* memory) const { fftwf_execute_dft(plan_, complexes(memory), complexes(memory)); }

  private:
    fftwf_plan plan_ = nullptr;
};

// h(k,t) for `lanes` modes.
struct Heights {
    float re[lanes];
    float im[lanes];
};

Heights advance(const Modes& modes, size_t at, uint32_t now) {
    const float *forwardRe = &modes.forwardRe[at], *forwardIm = &modes.forwardIm[at];
    const float *backwardRe = &modes.backwardRe[at], *backwardIm = &modes.backwardIm[at];
    const uint32_t* frequency = &modes.frequency[at];
    Heights h;
    for (size_t l = 0; l < lanes; ++l) {
        const SineCosine turn = sineCosine(wavePhase(frequency[l], now));
        h.re[l] = (forwardRe[l] + backwardRe[l]) * turn.cosine - (forwardIm[l] - backwardIm[l]) * turn.sine;
        h.im[l] = (forwardIm[l] + backwardIm[l]) * turn.cosine + (forwardRe[l] - backwardRe[l]) * turn.sine;
    }
    return h;
}

class FftwWaves {
  public:
    FftwWaves(const Sea& sea, bool twoThreads) : sea_(sea), twoThreads_(twoThreads) {
        if (sea.count == 0) return;
        const size_t samples = sea.desc.samples;
        size_t widest = 0;
        for (uint32_t c = 0; c < sea.count; ++c) widest = std::max(widest, stride(c));
        columns_ = allocate(2 * samples * widest);
        for (FloatBuffer& row : rows_) row = allocate(samples * texel);
        rowPlan_.emplace(sea.desc.samples, pairs, pairs, rows_[0].get());
        columnPlans_.reserve(sea.count * halves);
        for (uint32_t c = 0; c < sea.count; ++c) {
            packing_[c] = wavePacking(sea.modes[c]);
            for (size_t half = 0; half < halves; ++half) {
                const Range range = columnsOf(c, half);
                columnPlans_.emplace_back(sea.desc.samples, (range.end - range.begin) * waveColumnFields,
                                          stride(c), columnPoint(c, 0, range.begin));
            }
        }
    }

    // The work is cut in the same two halves whether one thread does both or each has its own, so that the
    // bits are the same.
    void evaluate(uint32_t cascade, double time, const CascadeMaps& out) {
        if (cascade >= sea_.count) return;
        const uint32_t now = loopPhase(time, sea_.desc.loopPeriod);
        std::thread other;
        std::latch columnsDone(halves);
        if (twoThreads_) {
            try {
                other = std::thread([&] {
                    transformColumns(cascade, 1, now);
                    columnsDone.arrive_and_wait();
                    makeRows(cascade, 1, out);
                });
            } catch (const std::system_error&) {
                // No thread to be had: this one does it all.
            }
        }
        transformColumns(cascade, 0, now);
        if (other.joinable()) {
            columnsDone.arrive_and_wait();
            makeRows(cascade, 0, out);
            other.join();
            return;
        }
        transformColumns(cascade, 1, now);
        for (size_t half = 0; half < halves; ++half) makeRows(cascade, half, out);
    }

  private:
    static constexpr size_t halves = 2;

    struct Range {
        size_t begin, end;
    };

    size_t width(uint32_t cascade) const { return static_cast<size_t>(sea_.modes[cascade].reach) + 1; }

    // The columns m of a half; it begins at a multiple of four, for FFTW's sake.
    Range columnsOf(uint32_t cascade, size_t half) const {
        const size_t middle = std::min((width(cascade) / 2 + 3) / 4 * 4, width(cascade));
        return half == 0 ? Range{0, middle} : Range{middle, width(cascade)};
    }

    // Complexes from one row to the next; not a power of two, which would crowd one set of the cache.
    size_t stride(uint32_t cascade) const { return (width(cascade) * waveColumnFields + 3) / 4 * 4 + 4; }

    float* columnPoint(uint32_t cascade, size_t row, size_t column) {
        return columns_.get() + 2 * (row * stride(cascade) + column * waveColumnFields);
    }

    void transformColumns(uint32_t cascade, size_t half, uint32_t now) {
        const Range range = columnsOf(cascade, half);
        if (range.begin == range.end) return;
        fillColumns(cascade, range, now);
        columnPlans_[cascade * halves + half].execute(columnPoint(cascade, 0, range.begin));
    }

    void fillColumns(uint32_t cascade, Range range, uint32_t now) {
        const Modes& modes = sea_.modes[cascade];
        const auto reach = static_cast<size_t>(modes.reach);
        const size_t samples = sea_.desc.samples;
        for (size_t row = 0; row < samples; ++row)
            std::fill(columnPoint(cascade, row, range.begin), columnPoint(cascade, row, range.end), 0.0f);
        const float dk = static_cast<float>(2 * std::numbers::pi / sea_.cascades[cascade].patch);
        for (size_t n = 0; n <= reach; ++n) {
            const float kv = dk * static_cast<float>(n);
            float* ahead = columnPoint(cascade, n, 0);
            float* behind = columnPoint(cascade, (samples - n) % samples, 0);
            // Columns m of the range, and -m.
            fillRow(modes, n, {reach + range.begin, reach + range.end}, now,
                    [&](size_t at, float re, float im) {
                        const size_t m = at % modes.pitch - reach;
                        if (n == 0 && m == 0) return;
                        const float d = sea_.desc.choppiness * modes.inverseK[at];
                        writeColumn(ahead + 2 * m * waveColumnFields, re, im, kv, d);
                        if (m == 0) writeColumn(behind, re, -im, -kv, d);
                    });
            if (n == 0) continue;
            fillRow(modes, n, {reach + 1 - range.end, reach + 1 - range.begin}, now,
                    [&](size_t at, float re, float im) {
                        const size_t m = reach - at % modes.pitch;
                        if (m == 0) return;
                        writeColumn(behind + 2 * m * waveColumnFields, re, -im, -kv,
                                    sea_.desc.choppiness * modes.inverseK[at]);
                    });
        }
    }

    // Calls each(at, re, im) with h(k,t) of the modes of row n whose columns are in the range.
    template<typename Each>
    static void fillRow(const Modes& modes, size_t n, Range range, uint32_t now, Each&& each) {
        for (size_t block = range.begin / lanes * lanes; block < range.end; block += lanes) {
            const size_t at = n * modes.pitch + block;
            const Heights h = advance(modes, at, now);
            const size_t first = std::max(block, range.begin) - block;
            const size_t last = std::min(block + lanes, range.end) - block;
            for (size_t l = first; l < last; ++l) each(at + l, h.re[l], h.im[l]);
        }
    }

    // The five fields of wave_fields.h.
    static void writeColumn(float* out, float re, float im, float kv, float d) {
        const float factors[waveColumnFields] = {1, d, kv * d, kv * (1 - kv * d), kv * (1 + kv * d)};
        for (size_t f = 0; f < waveColumnFields; ++f) {
            out[2 * f] = factors[f] * re;
            out[2 * f + 1] = factors[f] * im;
        }
    }

    void makeRows(uint32_t cascade, size_t half, const CascadeMaps& out) {
        const size_t count = sea_.desc.samples / halves;
        float* row = rows_[half].get();
        for (size_t j = half * count; j < (half + 1) * count; ++j) {
            fillRowOfPairs(cascade, columnPoint(cascade, j, 0), row);
            rowPlan_->execute(row);
            writeMaps(row, j, 1 / packing_[cascade], out);
        }
    }

    // (Dx, dDx/du), (h, dh/du), (Dz, dDx/dv), (dh/dv, dDz/dv) at ku and -ku.
    void fillRowOfPairs(uint32_t cascade, const float* columns, float* row) const {
        const size_t samples = sea_.desc.samples, columnCount = width(cascade);
        const float dk = static_cast<float>(2 * std::numbers::pi / sea_.cascades[cascade].patch);
        const float s = packing_[cascade];
        std::fill(row + columnCount * texel, row + (samples + 1 - columnCount) * texel, 0.0f);
        for (size_t m = 0; m < columnCount; ++m) {
            const float* in = columns + 2 * m * waveColumnFields;
            const float ku = dk * static_cast<float>(m);
            const float less = 1 - s * ku, more = 1 + s * ku;
            float* ahead = row + m * texel;
            ahead[0] = -ku * less * in[3];
            ahead[1] = ku * less * in[2];
            ahead[2] = less * in[0];
            ahead[3] = less * in[1];
            ahead[4] = -less * in[5];
            ahead[5] = less * in[4];
            ahead[6] = -in[7];
            ahead[7] = in[6];
            if (m == 0) continue;
            float* behind = row + (samples - m) * texel;
            behind[0] = -ku * more * in[3];
            behind[1] = -ku * more * in[2];
            behind[2] = more * in[0];
            behind[3] = -more * in[1];
            behind[4] = -more * in[5];
            behind[5] = -more * in[4];
            behind[6] = -in[9];
            behind[7] = -in[8];
        }
    }

    void writeMaps(const float* row, size_t j, float unpack, const CascadeMaps& out) const {
        const size_t samples = sea_.desc.samples;
        float* displacement = out.displacement + j * samples * 4;
        float* derivatives = out.derivatives + j * samples * 4;
        float* moments = out.moments + j * samples * 4;
        for (size_t i = 0; i < samples; ++i) {
            const float* in = row + i * texel;
            const float slopeU = in[3] * unpack, slopeV = in[6];
            const float stretchU = in[1] * unpack, stretchV = in[7];
            const float shear = in[5] * unpack;
            displacement[4 * i] = in[0];
            displacement[4 * i + 1] = in[2];
            displacement[4 * i + 2] = in[4];
            displacement[4 * i + 3] = shear;
            derivatives[4 * i] = slopeU;
            derivatives[4 * i + 1] = slopeV;
            derivatives[4 * i + 2] = stretchU;
            derivatives[4 * i + 3] = stretchV;
            moments[4 * i] = slopeU * slopeU;
            moments[4 * i + 1] = slopeV * slopeV;
            moments[4 * i + 2] = slopeU * slopeV;
            moments[4 * i + 3] = shear;
        }
    }

    const Sea& sea_;
    bool twoThreads_;
    std::array<float, maxCascades> packing_{};
    FloatBuffer columns_;      ///< [v][m][field], rows of stride()
    FloatBuffer rows_[halves]; ///< [u][pair]
    std::vector<Plan> columnPlans_;
    std::optional<Plan> rowPlan_;
};

template<bool twoThreads>
void* createWaves(const Sea& sea) {
    try {
        return new FftwWaves(sea, twoThreads);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

template<bool twoThreads>
constexpr WavesBackend backend{
    .name = "fftw",
    .create = createWaves<twoThreads>,
    .destroy = [](void* state) { delete static_cast<FftwWaves*>(state); },
    .evaluate = [](void* state, uint32_t cascade, double time,
                   const CascadeMaps& out) { static_cast<FftwWaves*>(state)->evaluate(cascade, time, out); },
};

} // namespace

const WavesBackend* fftwWaves(uint32_t threads) {
    return threads > 1 ? &backend<true> : &backend<false>;
}

} // namespace seaglass
