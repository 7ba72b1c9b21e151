// The exclusion volumes of a scene as Seaglass is told of them.
#pragma once

#include <string>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// False with `error` set where an outline is not convex, or has too many corners for a volume. They stand at
/// `path` of the scene.
bool exclusionVolumesOf(const std::vector<ExclusionVolumeDesc>& volumes, const std::string& path,
                        std::vector<seaglass::ExclusionVolume>& out, Error& error);

/// Adds those that a mesh keeps dry, where it is; they are as they can be.
void addCarried(const MeshDesc& mesh, const glm::dmat4& worldFromMesh,
                std::vector<seaglass::ExclusionVolume>& out);

} // namespace demos
