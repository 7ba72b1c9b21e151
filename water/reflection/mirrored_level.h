// Which plane waves are taken for near their own height: a crest lies above the calm plane and a trough below
// it, so that an eye at the calm plane is in the air as often as in the water.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "gpu/view/view.h"

namespace seaglass {

struct Body;

/// What the reflection is mirrored in, and how much of it shows.
struct MirroredLevel {
    double raised = 0; ///< over the calm plane [m]
    float share = 1;
};

/// Of an eye over the waves, as it was last asked for.
struct EyeOverWaves {
    glm::dvec3 eye{0};
    double time = 0, height = 0; ///< [s], [m]
};

/// An eye in the air looks down on what it mirrors, and one in the water up, whichever side of the calm plane
/// it is on. `last` spares a second query of the same height.
MirroredLevel mirroredLevel(const Body& body, const ViewGeometry& geometry,
                            std::optional<EyeOverWaves>& last);

} // namespace seaglass
