#include "water/reflection/mirrored_level.h"

#include <algorithm>
#include <cmath>

#include "water/body/body.h"
#include "water/sea/smoothstep.h"

namespace seaglass {

namespace {

/// From the eye to the plane at least; and the way from the waves over which the reflection comes [m].
constexpr double leastHeight = 0.1;

double heightOverWaves(const Body& body, const glm::dvec3& eye, std::optional<EyeOverWaves>& last) {
    if (!last || last->eye != eye || last->time != body.simulatedTime) {
        HeightSample sample;
        const double place[2] = {eye.x, eye.z};
        sampleHeights(*body.sea, body.simulatedTime, place, 1, &sample);
        last = EyeOverWaves{eye, body.simulatedTime, body.heightOf(eye) - double{sample.height}};
    }
    return last->height;
}

} // namespace

MirroredLevel mirroredLevel(const Body& body, const ViewGeometry& geometry,
                            std::optional<EyeOverWaves>& last) {
    if (!body.sea || geometry.parallel) return {};
    const double height = body.heightOf(geometry.eye);
    if (std::abs(height) > body.placing.displacement + leastHeight) return {};
    const double over = body.mayBeWet(geometry.eye) ? heightOverWaves(body, geometry.eye, last) : leastHeight;
    const double kept = over < 0 ? std::min(height, -leastHeight) : std::max(height, leastHeight);
    return {height - kept, static_cast<float>(smoothstep(0, leastHeight, std::abs(over)))};
}

} // namespace seaglass
