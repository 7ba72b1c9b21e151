// A floor's rectangle in space.
#pragma once

#include "host/camera.h"
#include "scene/floor.h"

namespace demos {

struct FloorPlane {
    glm::dvec3 middle{0};
    glm::dvec3 normal{0, 1, 0}; ///< unit
    glm::dvec3 across{1, 0, 0}; ///< unit, along its width
    glm::dvec3 along{0, 0, 1};  ///< unit, along its length; across x along = -normal
};

inline FloorPlane floorPlane(const FloorDesc& desc) {
    FloorPlane plane;
    plane.middle = toGlm(desc.pointM);
    plane.normal = glm::normalize(toGlm(desc.normal));
    const glm::dvec3 level = glm::cross(glm::dvec3(0, 1, 0), plane.normal);
    const double length = glm::length(level);
    plane.across = length > 1e-9 ? level / length : glm::dvec3(1, 0, 0);
    plane.along = glm::cross(plane.across, plane.normal);
    return plane;
}

} // namespace demos
