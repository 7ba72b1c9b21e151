// SSPR's scatter once more, in double and one pixel after another.
#pragma once

#include <vector>

#include "tests/gpu/rig/traced_scene.h"

namespace tests {

struct MirroredDepth {
    float nearest = 0; ///< of what is mirrored there, reversed depth; 0: nothing is
    bool sure = true;  ///< nothing falls so near to a border, or to the plane, that rounding decides
    bool differsFrom(float found) const { return sure && std::abs(found - nearest) > 1e-4f * nearest; }
};

/// Of each pixel, in the plane y = 0, for a camera with reversed depth.
inline std::vector<MirroredDepth> mirroredDepths(const Camera& camera, const TracedView& traced) {
    constexpr double border = 0.01, contact = 0.01; // [pixel], [m]
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    const glm::dmat4 inverse = glm::inverse(clip);
    const glm::dvec2 size(traced.width, traced.height);
    std::vector<MirroredDepth> depths(traced.depth.size());
    const auto at = [&](const glm::dvec2& pixel) -> MirroredDepth* {
        if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return nullptr;
        return &depths[static_cast<size_t>(pixel.y) * traced.width + static_cast<size_t>(pixel.x)];
    };
    for (uint32_t y = 0; y < traced.height; ++y)
        for (uint32_t x = 0; x < traced.width; ++x) {
            const double depth = double{traced.depth[size_t{y} * traced.width + x]};
            if (depth == 0) continue;
            const glm::dvec2 seen = (glm::dvec2(x, y) + 0.5) / size * 2.0 - 1.0;
            glm::dvec4 p = inverse * glm::dvec4(seen, depth, 1);
            p /= p.w;
            const double height = p.y;
            p.y = -p.y;
            const glm::dvec4 q = clip * p;
            if (height < 0 || q.w <= 0) continue;
            const glm::dvec2 pixel = (glm::dvec2(q) / q.w * 0.5 + 0.5) * size;
            for (const double dx : {-border, border})
                for (const double dy : {-border, border}) {
                    MirroredDepth* const there = at(pixel + glm::dvec2(dx, dy));
                    if (there && (there != at(pixel) || height < contact)) there->sure = false;
                }
            if (MirroredDepth* const there = at(pixel); there && height >= contact)
                there->nearest = std::max(there->nearest, static_cast<float>(q.z / q.w));
            else if (there)
                there->sure = false;
        }
    return depths;
}

} // namespace tests
