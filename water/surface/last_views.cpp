#include "water/surface/last_views.h"

#include <utility>

namespace seaglass {

glm::mat4 LastViews::pixelFromRelative(const ViewDesc& view, const ViewGeometry& geometry) {
    const LastView now{geometry.pixelFromRelative, geometry.eye, geometry.jitter};
    const auto [entry, fresh] = views_.try_emplace(view.viewIndex, now);
    const LastView last = std::exchange(entry->second, now);
    if (fresh || view.cut) return glm::mat4(now.pixelFromRelative);
    glm::dmat4 moved(1), steadied(1);
    moved[3] = glm::dvec4(geometry.eye - last.eye, 1);
    steadied[3] = glm::dvec4(now.jitter - last.jitter, 0, 1);
    return glm::mat4(steadied * last.pixelFromRelative * moved);
}

} // namespace seaglass
