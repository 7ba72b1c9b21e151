#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "scene/surroundings.h"

namespace demos {

/// Where a mesh stands. Its yaw turns as every azimuth here does, from +X towards +Z.
bool placement(const MeshDesc& desc, glm::dmat4& worldFromMesh, Error& error);

} // namespace demos
