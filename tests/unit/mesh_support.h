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

/// A patch in metres, as seen from the eye.
struct PlacedPatch {
    glm::dvec2 corner;
    double cell, range;
};

inline PlacedPatch placed(const seaglass::MeshLattice& lattice, const seaglass::MeshPatch& patch) {
    return {lattice.cornerOf(patch), double{patch.cell}, double{patch.range}};
}

} // namespace tests
