#include "metrics/difference.h"

#include <algorithm>
#include <cmath>

#include "metrics/finite.h"

namespace demos {

namespace {

double off(const Image& a, const Image& b, size_t value) {
    return std::abs(static_cast<double>(a.rgba[value]) - static_cast<double>(b.rgba[value]));
}

} // namespace

Difference difference(const Image& a, const Image& b) {
    Difference found;
    uint64_t values = 0;
    for (size_t i = 0; i < a.pixels(); ++i) {
        if (!isFinite(a, i) || !isFinite(b, i)) continue;
        for (size_t channel = 0; channel < 3; ++channel) {
            const double by = off(a, b, 4 * i + channel);
            found.mean += by;
            found.meanSquare += by * by;
            found.max = std::max(found.max, by);
        }
        values += 3;
    }
    if (values == 0) return found;
    found.mean /= static_cast<double>(values);
    found.meanSquare /= static_cast<double>(values);
    return found;
}

double shareOver(const Image& a, const Image& b, double limit) {
    if (a.pixels() == 0) return 0;
    uint64_t over = 0;
    for (size_t i = 0; i < a.pixels(); ++i) {
        const double worst = std::max({off(a, b, 4 * i), off(a, b, 4 * i + 1), off(a, b, 4 * i + 2)});
        if (!isFinite(a, i) || !isFinite(b, i) || worst > limit) ++over;
    }
    return static_cast<double>(over) / static_cast<double>(a.pixels());
}

} // namespace demos
