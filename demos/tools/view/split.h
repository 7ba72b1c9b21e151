// The picture in two halves, which differ in how the scene is mirrored, or drawn at all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "scene/scene.h"

namespace demos {

struct Split {
    seaglass::ReflectionDesc reflection; ///< of the right half; the left one's is the scene's own
    double at = 0.5;                     ///< of the width
    bool reference = false;              ///< the right half is ray traced instead
};

/// The surface of the right half; none where the scene has nothing that mirrors.
inline std::optional<SurfaceDesc> otherSurface(const Scene& scene, const Split& split) {
    std::optional<SurfaceDesc> surface = surfaceOf(scene);
    if (surface) std::visit([&](auto& desc) { desc.reflection = split.reflection; }, *surface);
    return surface;
}

/// Columns of the left half.
inline uint32_t leftColumns(const Split& split, uint32_t width) {
    return static_cast<uint32_t>(std::lround(std::clamp(split.at, 0.0, 1.0) * width));
}

} // namespace demos
