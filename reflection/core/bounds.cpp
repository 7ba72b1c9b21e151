#include "reflection/core/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace seaglass {

namespace {

using Corners = std::array<glm::dvec4, 8>;

/// Homogeneous pixels of the region.
Corners cornersOf(const Bounds& bounds, const ViewGeometry& view) {
    Corners corners;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1 ? bounds.high : bounds.low).x, (i & 2 ? bounds.high : bounds.low).y,
                                (i & 4 ? bounds.high : bounds.low).z);
        corners[static_cast<size_t>(i)] =
            view.pixelFromRelative * glm::dvec4(bounds.axes * corner - view.eye, 1);
    }
    return corners;
}

/// Whether all of it lies beyond one side of what the view sees. The far side sees everything: where that is
/// depends on the projection, and little is won there.
bool isOutside(const Corners& corners, const ViewGeometry& view) {
    const glm::dvec2 size(view.regionSize);
    const auto all = [&](auto&& beyond) { return std::ranges::all_of(corners, beyond); };
    return all([](const glm::dvec4& p) { return p.x < 0; }) ||
           all([](const glm::dvec4& p) { return p.y < 0; }) ||
           all([&](const glm::dvec4& p) { return p.x > size.x * p.w; }) ||
           all([&](const glm::dvec4& p) { return p.y > size.y * p.w; }) ||
           all([&](const glm::dvec4& p) { return view.reversedDepth ? p.z > p.w : p.z < 0; });
}

} // namespace

const char* readBounds(const double (&low)[3], const double (&high)[3], Bounds& out) {
    const auto each = [&](auto&& is) { return is(0) && is(1) && is(2); };
    out.everywhere = each([&](int i) { return std::isinf(low[i]) && low[i] < 0; }) &&
                     each([&](int i) { return std::isinf(high[i]) && high[i] > 0; });
    if (out.everywhere) return nullptr;
    if (!each([&](int i) { return std::isfinite(low[i]) && std::isfinite(high[i]) && low[i] <= high[i]; }))
        return "boundsLow and boundsHigh are no box: expected finite numbers, the low ones not above the "
               "high, or all of them infinite";
    out.low = {low[0], low[1], low[2]};
    out.high = {high[0], high[1], high[2]};
    return nullptr;
}

glm::ivec4 pixelsThatMayShow(const Bounds& bounds, const ViewGeometry& view) {
    const glm::ivec4 all(0, 0, view.regionSize);
    if (bounds.everywhere) return all;
    const Corners corners = cornersOf(bounds, view);
    if (isOutside(corners, view)) return glm::ivec4(0);
    // Some of it beside or behind the eye: where that would show, no division tells.
    if (std::ranges::any_of(corners, [](const glm::dvec4& p) { return !(p.w > 1e-9); })) return all;
    const glm::dvec2 size(view.regionSize);
    glm::dvec2 low = size, high(0);
    for (const glm::dvec4& p : corners) {
        low = glm::min(low, glm::dvec2(p) / p.w);
        high = glm::max(high, glm::dvec2(p) / p.w);
    }
    low = glm::clamp(glm::floor(low), glm::dvec2(0), size);
    high = glm::clamp(glm::ceil(high), glm::dvec2(0), size);
    const glm::ivec4 pixels(low.x, low.y, high.x, high.y);
    return isEmpty(pixels) ? glm::ivec4(0) : pixels;
}

} // namespace seaglass
