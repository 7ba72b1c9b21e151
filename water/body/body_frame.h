// A body's own axes: the world's, turned about its origin by the smallest rotation that takes +Y to the
// normal of the body's plane. In them every plane is level, y = -d, and (x, z) are the sea's (u, v): the
// water is written for level planes alone, and what the host says in the world's axes is turned where it
// comes in, in double. Reflectors, which take any plane, stay in the world.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "water/body/exclusion_volumes.h"

namespace seaglass {

struct BodyFrame {
    glm::dmat3 worldFromBody{1}; ///< its columns are u, the normal and v in the world
    bool tilted = false;         ///< false: both are the same, and nothing is turned

    /// Of a unit normal with y > -1.
    static BodyFrame of(const glm::dvec3& normal);

    /// Of a direction or, since both have their origin in one place, a point.
    glm::dvec3 fromWorld(const glm::dvec3& vector) const;
    ExclusionPlanes fromWorld(const ExclusionPlanes& planes) const;
    /// One from the body's axes to the same picture.
    ViewDesc fromWorld(const ViewDesc& view) const;
};

} // namespace seaglass
