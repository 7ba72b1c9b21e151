// How a sea's tiles are drawn out of shape, so that nobody sees them repeat: a place looks its waves up a
// little way aside on their tiles, by a shift that changes slowly from place to place (domain warping, Perlin
// 1985). Then no two places a tile apart show the same waves for long, and each map is still sampled once.
//
// The shift is a sum of slow waves, made of parabolas, which need no sine. It is level at the origin, and 0.
#pragma once

#include <array>
#include <cstddef>

namespace seaglass {

constexpr size_t warpScales = 3;

/// Wave vectors of the two waves that shift along u and along v [turns/m], and how far either way.
struct WarpScale {
    std::array<double, 2> u{}, v{};
    double amplitude = 0; ///< [m]
};

using Warp = std::array<WarpScale, warpScales>;

/// Of a sea whose largest tile has this edge [m]; `strength` is 0..1.
Warp warpOf(double largestPatch, double strength);

/// The shift at a place, and its gradient.
struct WarpShift {
    double u = 0, v = 0;   ///< [m]
    double uu = 0, uv = 0; ///< of u, along u and v
    double vu = 0, vv = 0; ///< of v
};

WarpShift warpAt(const Warp& warp, double u, double v);

/// What the waves of a warp sum up to where all are at rest, along u and along v alike [m].
double warpAtRest(const Warp& warp);

/// Where on its way a wave of a scale is at a place [turns], -1/2..1/2.
double warpTurns(const std::array<double, 2>& wave, double u, double v);

} // namespace seaglass
