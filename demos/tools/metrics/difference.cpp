#include "metrics/difference.h"

#include <algorithm>
#include <cmath>

#include "metrics/finite.h"

namespace demos {

namespace {

double off(const float* a, const float* b, size_t channel) {
    return std::abs(static_cast<double>(a[channel]) - static_cast<double>(b[channel]));
}

/// Whether `pixel` of `a` or of `b` has a NaN or an infinity.
bool isBroken(const PixelView& a, const PixelView& b, size_t pixel) {
    return !isFinite(a, pixel) || !isFinite(b, pixel);
}

bool isOver(const PixelView& a, const PixelView& b, size_t pixel, double limit) {
    const float *const p = &a.rgba[4 * pixel], *const q = &b.rgba[4 * pixel];
    return isBroken(a, b, pixel) ||
           std::max({off(p, q, 0), off(p, q, 1), off(p, q, 2), off(p, q, 3)}) > limit;
}

/// How far a pixel of `a` is at most, in a channel, from the range of the nine pixels there in `b`.
double offAround(const PixelView& a, const PixelView& b, size_t pixel) {
    const size_t x = pixel % a.width, y = pixel / a.width;
    double most = 0;
    for (size_t channel = 0; channel < 4; ++channel) {
        const auto value = static_cast<double>(a.rgba[4 * pixel + channel]);
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t row = y - std::min<size_t>(y, 1); row <= std::min<size_t>(y + 1, a.height - 1); ++row) {
            for (size_t at = x - std::min<size_t>(x, 1); at <= std::min<size_t>(x + 1, a.width - 1); ++at) {
                const auto other = static_cast<double>(b.rgba[4 * (row * a.width + at) + channel]);
                low = std::min(low, other);
                high = std::max(high, other);
            }
        }
        most = std::max({most, low - value, value - high});
    }
    return most;
}

template<class IsOver>
double shareOf(const PixelView& a, const IsOver& isOver) {
    if (a.pixels() == 0) return 0;
    uint64_t over = 0;
    for (size_t i = 0; i < a.pixels(); ++i)
        if (isOver(i)) ++over;
    return static_cast<double>(over) / static_cast<double>(a.pixels());
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
        found.alpha = std::max(found.alpha, off(&a.rgba[4 * i], &b.rgba[4 * i], 3));
        values += 3;
    }
    values -= 3 * leftOut;
    if (values == 0) return found;
    found.mean /= static_cast<double>(values);
    found.meanSquare /= static_cast<double>(values);
    return found;
}

double shareOver(const PixelView& a, const PixelView& b, double limit) {
    return shareOf(a, [&](size_t i) { return isOver(a, b, i, limit); });
}

double shareOfAlphaOver(const PixelView& a, const PixelView& b, double limit) {
    return shareOf(a, [&](size_t i) { return off(&a.rgba[4 * i], &b.rgba[4 * i], 3) > limit; });
}

double shareUnlikeAround(const PixelView& a, const PixelView& b, double limit) {
    return shareOf(a, [&](size_t i) {
        if (!isOver(a, b, i, limit)) return false;
        return isBroken(a, b, i) || std::max(offAround(a, b, i), offAround(b, a, i)) > limit;
    });
}

} // namespace demos
