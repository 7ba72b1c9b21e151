// The exclusion volumes of a scene as Seaglass is told of them.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// False with `error` set where an outline is not convex, or has too many corners for a room.
bool exclusionVolumesOf(const std::vector<ExclusionVolumeDesc>& rooms,
                        std::vector<seaglass::ExclusionVolume>& out, Error& error);

} // namespace demos
