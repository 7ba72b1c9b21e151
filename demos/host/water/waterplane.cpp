#include "host/water/waterplane.h"

#include <limits>

namespace demos {

std::optional<Waterplane> waterplaneAt(const Mesh& mesh, double height) {
    glm::dvec2 low(std::numeric_limits<double>::max()), high = -low;
    const auto cross = [&](const glm::dvec3& a, const glm::dvec3& b) {
        if ((a.y < height) == (b.y < height)) return;
        const glm::dvec3 at = glm::mix(a, b, (height - a.y) / (b.y - a.y));
        low = glm::min(low, glm::dvec2(at.x, at.z));
        high = glm::max(high, glm::dvec2(at.x, at.z));
    };
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 corners[3];
        for (size_t c = 0; c < 3; ++c) corners[c] = glm::dvec3(mesh.vertices[mesh.indices[i + c]].position);
        for (size_t c = 0; c < 3; ++c) cross(corners[c], corners[(c + 1) % 3]);
    }
    if (low.x > high.x) return std::nullopt;
    const glm::dvec2 middle = (low + high) / 2.0;
    return Waterplane{{middle.x, height, middle.y}, (high - low) / 2.0};
}

} // namespace demos
