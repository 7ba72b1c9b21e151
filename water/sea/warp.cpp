#include "water/interface/warp.h"

#include <cmath>
#include <numbers>

namespace seaglass {
namespace {

// Lengths of the scales' waves, in largest tiles. The first is for views of dozens of tiles, the second parts
// neighbours, and the last does so for smaller tiles: where a picture is an eighth as wide, neighbours in it
// are shifted unlike.
constexpr std::array<double, warpScales> lengths = {20, 2.5, 0.4};
// Of the shift of a scale: what it makes waves shorter or longer by, a share, at the most.
constexpr double steepest = 0.2;

// Directions of scales are as far apart as can be. The wave along v has another length than that along u, so
// that the two never come round together.
constexpr double firstAngle = 0.35;
constexpr double goldenAngle = std::numbers::pi * (3 - 2.2360679774997896964);
constexpr double acrossAngle = 1.35;
constexpr double acrossLength = 0.87;

std::array<double, 2> waveOf(double angle, double length) {
    return {std::cos(angle) / length, std::sin(angle) / length};
}

} // namespace

Warp warpOf(double largestPatch, double strength) {
    Warp warp;
    for (size_t s = 0; s < warpScales; ++s) {
        const double length = lengths[s] * largestPatch;
        const double angle = firstAngle + goldenAngle * static_cast<double>(s);
        warp[s] = {waveOf(angle, length), waveOf(angle + acrossAngle, acrossLength * length),
                   strength * steepest / 8 * length};
    }
    return warp;
}

double warpTurns(const std::array<double, 2>& wave, double u, double v) {
    constexpr double crest = 0.25;
    const double turns = wave[0] * u + wave[1] * v + crest;
    return turns - std::round(turns);
}

double warpAtRest(const Warp& warp) {
    double sum = 0;
    for (const WarpScale& scale : warp) sum += scale.amplitude;
    return sum;
}

WarpShift warpAt(const Warp& warp, double u, double v) {
    WarpShift shift;
    for (const WarpScale& scale : warp) {
        const double a = 8 * scale.amplitude;
        const double t = warpTurns(scale.u, u, v), s = warpTurns(scale.v, u, v);
        shift.u += a * t * (1 - 2 * std::abs(t)) - scale.amplitude;
        shift.v += a * s * (1 - 2 * std::abs(s)) - scale.amplitude;
        const double rateU = a * (1 - 4 * std::abs(t)), rateV = a * (1 - 4 * std::abs(s));
        shift.uu += rateU * scale.u[0];
        shift.uv += rateU * scale.u[1];
        shift.vu += rateV * scale.v[0];
        shift.vv += rateV * scale.v[1];
    }
    return shift;
}

} // namespace seaglass
