// Axes in which a tilted plane is level.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace demos::reference {

/// The world's, turned about its origin by the smallest rotation that takes +Y to a normal.
struct LevelAxes {
    glm::dmat3 worldFromBody{1};
    bool tilted = false; ///< false: they are the world's own

    /// Of a unit normal with y > -1. Rodrigues: v + a x v + a x (a x v) / (1 + cos), of a = +Y x normal.
    static LevelAxes of(const glm::dvec3& normal) {
        LevelAxes axes;
        const glm::dvec3 up(0, 1, 0), turn = glm::cross(up, normal);
        if (glm::length(normal - up) < 1e-9) return axes;
        axes.tilted = true;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 axis = axes.worldFromBody[i], once = glm::cross(turn, axis);
            axes.worldFromBody[i] = axis + once + glm::cross(turn, once) / (1 + normal.y);
        }
        return axes;
    }

    /// Of a direction or a point.
    glm::dvec3 fromWorld(const glm::dvec3& vector) const { return tilted ? vector * worldFromBody : vector; }
};

} // namespace demos::reference
