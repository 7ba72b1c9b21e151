// A scene of boxes over a mirror, traced exactly on the CPU: the input that a host would rasterise, and the
// truth of what the mirror shows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include "tests/unit/cameras.h"

namespace tests {

struct Box {
    glm::dvec3 low;
    glm::dvec3 high;
    double lean = 0; ///< how far it leans towards +z for each metre above the plane
};

/// A pier, a tower, a crate, a far island and a slab in the air, over y = 0; some reach below it.
inline std::vector<Box> harbourOfBoxes() {
    return {
        {{-6, -3, -6}, {-5.6, 1.4, -5.6}}, {{-3, -3, -6}, {-2.6, 1.4, -5.6}},
        {{0, -3, -6}, {0.4, 1.4, -5.6}},   {{-7, 1.2, -7}, {1, 1.5, -5}},
        {{3, -1, -14}, {5, 8, -12}},       {{-2, -0.4, -2}, {-0.8, 0.7, -0.6}},
        {{-40, -2, -90}, {-5, 6, -80}},    {{1.5, 1.8, -4}, {3.5, 2.0, -2}},
    };
}

inline double hitDistance(const Box& box, glm::dvec3 origin, glm::dvec3 direction) {
    origin.z -= box.lean * origin.y;
    direction.z -= box.lean * direction.y;
    const glm::dvec3 a = (box.low - origin) / direction;
    const glm::dvec3 b = (box.high - origin) / direction;
    const glm::dvec3 first = glm::min(a, b);
    const glm::dvec3 last = glm::max(a, b);
    const double enter = std::max({first.x, first.y, first.z});
    const double leave = std::min({last.x, last.y, last.z});
    return enter <= leave && enter > 1e-9 ? enter : std::numeric_limits<double>::infinity();
}

inline double nearestHit(const std::vector<Box>& boxes, const glm::dvec3& origin,
                         const glm::dvec3& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes) nearest = std::min(nearest, hitDistance(box, origin, direction));
    return nearest;
}

enum class Truth {
    none, ///< the plane is not seen here, or something stands before it
    sky,
    recoverable, ///< what is mirrored is on the screen, and visible there
    lost,        ///< off the screen or hidden
};

struct TracedView {
    uint32_t width = 0, height = 0;
    std::vector<float> depth;
    std::vector<float> color; ///< RGBA: each pixel's own position in 0..1, so that a colour tells its source
    std::vector<Truth> truth;
    std::vector<double> distance;   ///< from the mirror to what it shows [m]; infinite: sky, or no mirror
    std::vector<glm::dvec2> source; ///< of recoverable pixels: where their mirrored point is seen [pixel]
};

class Tracer {
  public:
    /// `normal` tilts the mirror everywhere, without displacing it.
    Tracer(const Camera& camera, std::vector<Box> boxes, const glm::dvec3& normal = {0, 1, 0})
        : camera_(camera), boxes_(std::move(boxes)), normal_(glm::normalize(normal)) {
        clip_ = projectionMatrix(camera) * viewMatrix(camera);
        inverse_ = glm::inverse(clip_);
    }

    TracedView run() const {
        TracedView out;
        out.width = camera_.width;
        out.height = camera_.height;
        const size_t count = size_t{out.width} * out.height;
        out.depth.resize(count);
        out.color.resize(count * 4);
        out.truth.resize(count);
        out.source.resize(count);
        out.distance.assign(count, std::numeric_limits<double>::infinity());
        for (uint32_t y = 0; y < out.height; ++y)
            for (uint32_t x = 0; x < out.width; ++x) pixel(x, y, out);
        return out;
    }

  private:
    static bool inDepth(double depth) { return depth >= 0 && depth <= 1; }

    struct Line {
        glm::dvec3 from, direction;
    };

    glm::dvec3 unprojected(const glm::dvec2& ndc, double depth) const {
        const glm::dvec4 p = inverse_ * glm::dvec4(ndc, depth, 1);
        return glm::dvec3(p) / p.w;
    }

    /// From the eye, or from the near plane where lines of sight are parallel.
    Line lineThrough(const glm::dvec2& pixel) const {
        const glm::dvec2 ndc = pixel / glm::dvec2(camera_.width, camera_.height) * 2.0 - 1.0;
        if (camera_.parallelHeight == 0)
            return {camera_.eye, glm::normalize(unprojected(ndc, 0.5) - camera_.eye)};
        const glm::dvec3 near = unprojected(ndc, camera_.reversed ? 1 : 0);
        return {near, glm::normalize(unprojected(ndc, 0.5) - near)};
    }

    glm::dvec4 project(const glm::dvec3& world) const {
        const glm::dvec4 c = clip_ * glm::dvec4(world, 1);
        return {(c.x / c.w * 0.5 + 0.5) * camera_.width, (c.y / c.w * 0.5 + 0.5) * camera_.height, c.z / c.w,
                c.w};
    }

    void pixel(uint32_t x, uint32_t y, TracedView& out) const {
        const size_t i = size_t{y} * out.width + x;
        const glm::dvec2 centre(x + 0.5, y + 0.5);
        const auto& [from, ray] = lineThrough(centre);
        double hit = nearestHit(boxes_, from, ray);
        const double farDepth = camera_.reversed ? 0 : 1;
        if (!std::isinf(hit) && !inDepth(project(from + ray * hit).z))
            hit = std::numeric_limits<double>::infinity();
        out.depth[i] = static_cast<float>(std::isinf(hit) ? farDepth : project(from + ray * hit).z);
        const float values[4] = {static_cast<float>(centre.x / out.width),
                                 static_cast<float>(centre.y / out.height), 1, 1};
        std::copy(values, values + 4, out.color.begin() + static_cast<ptrdiff_t>(i * 4));
        out.truth[i] = Truth::none;
        const double toPlane = -from.y / ray.y;
        if (ray.y >= 0 || toPlane <= 0 || toPlane >= hit) return;
        const glm::dvec3 on = from + ray * toPlane;
        if (!inDepth(project(on).z)) return;
        const glm::dvec3 up = glm::reflect(ray, normal_);
        if (up.y <= 0) return;
        const double mirrored = nearestHit(boxes_, on, up);
        out.truth[i] = Truth::sky;
        out.distance[i] = mirrored;
        if (std::isinf(mirrored)) return;
        const glm::dvec3 point = on + up * mirrored;
        const glm::dvec4 seen = project(point);
        out.source[i] = glm::dvec2(seen);
        const bool onScreen = seen.w > 0 && seen.x >= 0 && seen.y >= 0 && seen.x < out.width &&
                              seen.y < out.height && inDepth(seen.z);
        const Line line = lineThrough(glm::dvec2(seen));
        const double visible = nearestHit(boxes_, line.from, line.direction);
        const bool same = std::abs(visible - glm::length(point - line.from)) < 1e-6 * visible;
        out.truth[i] = onScreen && same ? Truth::recoverable : Truth::lost;
    }

    Camera camera_;
    std::vector<Box> boxes_;
    glm::dvec3 normal_;
    glm::dmat4 clip_;
    glm::dmat4 inverse_;
};

} // namespace tests
