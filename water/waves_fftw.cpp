// The CPU wave backend: one inverse transform in two passes, by FFTW.
//
// Eight real fields make four complex ones. A spectrum fills only the columns |m| <= reach, so the pass along
// the columns does only those; the pass along the rows then goes row by row through a buffer that fits the
// first-level cache, straight into the maps.
#include "seaglass/waves_fftw.h"

#include "water/phase.h"
#include "water/sea.h"

#include <fftw3.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <new>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace seaglass {
namespace {

constexpr size_t pairs = 4;         ///< complex fields
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
    explicit FftwWaves(const Sea& sea) : sea_(sea) {
        if (sea.count == 0) return;
        const size_t samples = sea.desc.samples;
        size_t widest = 0;
        for (uint32_t c = 0; c < sea.count; ++c) widest = std::max(widest, stride(c));
        columns_ = allocate(2 * samples * widest);
        row_ = allocate(samples * texel);
        rowPlan_.emplace(sea.desc.samples, pairs, pairs, row_.get());
        columnPlans_.reserve(sea.count);
        for (uint32_t c = 0; c < sea.count; ++c)
            columnPlans_.emplace_back(sea.desc.samples, width(c) * pairs, stride(c), columns_.get());
    }

    void evaluate(uint32_t cascade, double time, const CascadeMaps& out) {
        if (cascade >= sea_.count) return;
        const size_t samples = sea_.desc.samples;
        fillColumns(cascade, loopPhase(time, sea_.desc.loopPeriod));
        columnPlans_[cascade].execute(columns_.get());

        const auto reach = static_cast<size_t>(sea_.modes[cascade].reach);
        for (size_t j = 0; j < samples; ++j) {
            const float* spectrum = columns_.get() + 2 * j * stride(cascade);
            float* row = row_.get();
            std::copy_n(spectrum + reach * texel, (reach + 1) * texel, row);
            std::fill_n(row + (reach + 1) * texel, (samples - 2 * reach - 1) * texel, 0.0f);
            std::copy_n(spectrum, reach * texel, row + (samples - reach) * texel);
            rowPlan_->execute(row);
            writeMaps(row, j, out);
        }
    }

  private:
    size_t width(uint32_t cascade) const { return 2 * static_cast<size_t>(sea_.modes[cascade].reach) + 1; }

    // Complexes from one row to the next; not a power of two, which would crowd one set of the cache.
    size_t stride(uint32_t cascade) const { return (width(cascade) + 3) / 4 * 4 * pairs + pairs; }

    float* columnTexel(uint32_t cascade, size_t row, size_t column) {
        return columns_.get() + 2 * row * stride(cascade) + column * texel;
    }

    // The spectra of the pairs f + i g, at k and at -k where both f and g are conjugate.
    void fillColumns(uint32_t cascade, uint32_t now) {
        const Modes& modes = sea_.modes[cascade];
        const auto reach = static_cast<size_t>(modes.reach);
        const size_t samples = sea_.desc.samples;
        std::fill_n(columns_.get(), 2 * samples * stride(cascade), 0.0f);
        const float dk = static_cast<float>(2 * std::numbers::pi / sea_.cascades[cascade].patch);
        for (size_t n = 0; n <= reach; ++n) {
            float* row = columnTexel(cascade, n, 0);
            float* mirrored = columnTexel(cascade, (samples - n) % samples, 2 * reach);
            const float kv = dk * static_cast<float>(n);
            for (size_t block = 0; block < modes.pitch; block += lanes) {
                const size_t at = n * modes.pitch + block;
                const Heights h = advance(modes, at, now);
                const size_t used = std::min(lanes, width(cascade) - std::min(width(cascade), block));
                for (size_t l = 0; l < used; ++l) {
                    const size_t c = block + l;
                    if (n == 0 && c <= reach) continue;
                    const float ku = dk * (static_cast<float>(c) - static_cast<float>(reach));
                    const float chop = sea_.desc.choppiness * modes.inverseK[at + l];
                    writePairs(row + c * texel, h.re[l], h.im[l], ku, kv, chop);
                    writePairs(mirrored - c * texel, h.re[l], -h.im[l], -ku, -kv, chop);
                }
            }
        }
    }

    // With d = choppiness/|k|: (Dx, h), (Dz, dDx/dv), (dh/du, dh/dv), (dDx/du, dDz/dv).
    static void writePairs(float* out, float re, float im, float ku, float kv, float d) {
        const float x = 1 + ku * d;
        out[0] = -x * im;
        out[1] = x * re;
        const float z = kv * d * (1 - ku);
        out[2] = -z * im;
        out[3] = z * re;
        out[4] = -kv * re - ku * im;
        out[5] = ku * re - kv * im;
        const float uu = -ku * ku * d, vv = -kv * kv * d;
        out[6] = uu * re - vv * im;
        out[7] = uu * im + vv * re;
    }

    void writeMaps(const float* row, size_t j, const CascadeMaps& out) const {
        const size_t samples = sea_.desc.samples;
        float* displacement = out.displacement + j * samples * 4;
        float* derivatives = out.derivatives + j * samples * 4;
        float* moments = out.moments + j * samples * 4;
        for (size_t i = 0; i < samples; ++i) {
            const float* in = row + i * texel;
            for (size_t f = 0; f < 4; ++f) displacement[4 * i + f] = in[f];
            for (size_t f = 0; f < 4; ++f) derivatives[4 * i + f] = in[4 + f];
            const float slopeU = in[4], slopeV = in[5], divergence = in[6] + in[7];
            moments[4 * i] = slopeU * slopeU;
            moments[4 * i + 1] = slopeV * slopeV;
            moments[4 * i + 2] = slopeU * slopeV;
            moments[4 * i + 3] = divergence * divergence;
        }
    }

    const Sea& sea_;
    FloatBuffer columns_; ///< [v][m][pair], rows of stride()
    FloatBuffer row_;     ///< [u][pair]
    std::vector<Plan> columnPlans_;
    std::optional<Plan> rowPlan_;
};

void* createWaves(const Sea& sea) {
    try {
        return new FftwWaves(sea);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

} // namespace

const WavesBackend* fftwWaves() {
    static constexpr WavesBackend backend{
        .name = "fftw",
        .create = createWaves,
        .destroy = [](void* state) { delete static_cast<FftwWaves*>(state); },
        .evaluate =
            [](void* state, uint32_t cascade, double time, const CascadeMaps& out) {
                static_cast<FftwWaves*>(state)->evaluate(cascade, time, out);
            },
    };
    return &backend;
}

} // namespace seaglass
