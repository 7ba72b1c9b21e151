#include "water/body/body_frame.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "gpu/view/view.h"

namespace seaglass {

BodyFrame BodyFrame::of(const glm::dvec3& n) {
    BodyFrame frame;
    if (glm::length(n - glm::dvec3(0, 1, 0)) < 1e-9) return frame;
    // Rodrigues' rotation about n x Y, by its sine and cosine (x, z) and y.
    const double share = 1 / (1 + n.y), both = -n.x * n.z * share;
    frame.worldFromBody = {{1 - n.x * n.x * share, -n.x, both}, n, {both, -n.z, 1 - n.z * n.z * share}};
    frame.tilted = true;
    return frame;
}

glm::dvec3 BodyFrame::fromWorld(const glm::dvec3& vector) const {
    return tilted ? vector * worldFromBody : vector;
}

ExclusionPlanes BodyFrame::fromWorld(const ExclusionPlanes& planes) const {
    ExclusionPlanes turned = planes;
    for (glm::dvec4& plane : turned) plane = glm::dvec4(fromWorld(glm::dvec3(plane)), plane.w);
    return turned;
}

ViewDesc BodyFrame::fromWorld(const ViewDesc& view) const {
    if (!tilted) return view;
    ViewDesc turned = view;
    toValues(toMatrix(view.view) * glm::dmat4(worldFromBody), turned.view);
    return turned;
}

} // namespace seaglass
