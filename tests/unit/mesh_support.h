// Views that meshes are tested from.
#pragma once

#include "water/mesh/mesh.h"

namespace tests {

/// A view that sees everything.
inline seaglass::MeshView allAround(const glm::dvec2& eye, double height) {
    seaglass::MeshView view;
    view.eye = eye;
    view.eyeHeight = height;
    view.frustum.fill(glm::dvec4(0, 0, 0, 1));
    return view;
}

} // namespace tests
