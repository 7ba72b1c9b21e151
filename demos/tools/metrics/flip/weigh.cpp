#include "metrics/flip/weigh.h"

#include <array>

namespace demos {

namespace {

template<Kernel::Kind kind>
void weighBlock(const Kernel& kernel, const float* const* at, size_t from, float* to) {
    std::array<float, valuesAtOnce> sums{};
    const float* const here = at[0] + from;
    if constexpr (kind == Kernel::Kind::mean) {
        for (size_t i = 0; i < valuesAtOnce; ++i) sums[i] = kernel.weights[0] * here[i];
    }
    for (size_t k = 1; k < kernel.weights.size(); ++k) {
        const float weight = kernel.weights[k];
        const float *const after = at[k] + from, *const before = at[-static_cast<std::ptrdiff_t>(k)] + from;
        for (size_t i = 0; i < valuesAtOnce; ++i) {
            if constexpr (kind == Kernel::Kind::mean)
                sums[i] += weight * (after[i] + before[i]);
            else if constexpr (kind == Kernel::Kind::slope)
                sums[i] += weight * (after[i] - before[i]);
            else
                sums[i] += weight * (after[i] + before[i] - 2 * here[i]);
        }
    }
    for (size_t i = 0; i < valuesAtOnce; ++i) to[from + i] = sums[i];
}

template<Kernel::Kind kind>
void weighRow(const Kernel& kernel, const float* const* at, float* to, size_t width) {
    for (size_t from = 0; from < width; from += valuesAtOnce) weighBlock<kind>(kernel, at, from, to);
}

} // namespace

void weigh(const Kernel& kernel, const float* const* at, float* to, size_t width) {
    switch (kernel.kind) {
    case Kernel::Kind::mean:
        return weighRow<Kernel::Kind::mean>(kernel, at, to, width);
    case Kernel::Kind::slope:
        return weighRow<Kernel::Kind::slope>(kernel, at, to, width);
    case Kernel::Kind::bend:
        return weighRow<Kernel::Kind::bend>(kernel, at, to, width);
    }
}

} // namespace demos
