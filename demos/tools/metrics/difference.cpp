#include "metrics/difference.h"

#include <algorithm>
#include <cmath>

#include "metrics/finite.h"

namespace demos {

namespace {

double off(const float* a, const float* b, size_t channel) {
    return std::abs(static_cast<double>(a[channel]) - static_cast<double>(b[channel]));
}

} // namespace

Difference difference(const PixelView& a, const PixelView& b, size_t leftOut) {
    Difference found;
    uint64_t values = 0;
    for (size_t i = 0; i < a.pixels(); ++i) {
        if (!isFinite(a, i) || !isFinite(b, i)) continue;
        for (size_t channel = 0; channel < 3; ++channel) {
            const double by = off(&a.rgba[4 * i], &b.rgba[4 * i], channel);
            found.mean += by;
            found.meanSquare += by * by;
            found.max = std::max(found.max, by);
        }
        values += 3;
    }
    values -= 3 * leftOut;
    if (values == 0) return found;
    found.mean /= static_cast<double>(values);
    found.meanSquare /= static_cast<double>(values);
    return found;
}

double shareOver(const PixelView& a, const PixelView& b, double limit) {
    if (a.pixels() == 0) return 0;
    uint64_t over = 0;
    for (size_t i = 0; i < a.pixels(); ++i) {
        const float *const p = &a.rgba[4 * i], *const q = &b.rgba[4 * i];
        const double worst = std::max(std::max(off(p, q, 0), off(p, q, 1)), off(p, q, 2));
        if (worst > limit || !isFinite(a, i) || !isFinite(b, i)) ++over;
    }
    return static_cast<double>(over) / static_cast<double>(a.pixels());
}

} // namespace demos
