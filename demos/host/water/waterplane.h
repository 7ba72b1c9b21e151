// What of calm water a mesh takes up.
#pragma once

#include <optional>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "host/files/mesh_file.h"

namespace demos {

/// A rectangle in the mesh's own axes, along its x and z.
struct Waterplane {
    glm::dvec3 middle{0};
    glm::dvec2 half{0};
};

/// Around where its triangles cross this height of its own; none where they do not.
std::optional<Waterplane> waterplaneAt(const Mesh& mesh, double height);

} // namespace demos
