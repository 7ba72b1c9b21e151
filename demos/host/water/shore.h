// The bed of a scene's shore as Seaglass is told of it.
#pragma once

#include <vector>

#include "scene/water_plane.h"
#include "seaglass/sea.h"

namespace demos {

/// A description and what it refers to. Moves, but does not copy.
struct SceneShore {
    SceneShore() = default;
    SceneShore(SceneShore&&) = default;
    SceneShore& operator=(SceneShore&&) = default;

    seaglass::ShoreDesc desc;
    std::vector<float> bed;
};

/// The highest of the mesh at each sample, over the water's plane; where it has nothing, its lowest point.
/// False with `error` set when the mesh cannot be read, or has too many samples.
bool shoreOf(const ShoreDesc& shore, const Plane& plane, SceneShore& out, Error& error);

} // namespace demos
