// The exclusion volumes of a scene as Seaglass is told of them.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// False with `error` set where an outline is not convex, or has too many corners for a volume.
bool exclusionVolumesOf(const std::vector<ExclusionVolumeDesc>& volumes,
                        std::vector<seaglass::ExclusionVolume>& out, Error& error);

} // namespace demos
