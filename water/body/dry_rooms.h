// Convex hollows that a body's water stays out of: the insides of boats.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "seaglass/water.h"
#include "shaders/shared/body_block.h"

namespace seaglass {

/// Unit normals outwards, in the world [m].
using DryPlanes = std::array<glm::dvec4, dryRoomPlanes>;

/// Null when the rooms are usable, else what is wrong with one. Fills `out`.
const char* readDryRooms(const DryRoom* rooms, uint32_t count, std::vector<DryPlanes>& out);

/// How many the shaders look at: a power of two, so that few pipelines serve, or none.
uint32_t roomsPacked(const std::vector<DryPlanes>& rooms);

bool isDry(const std::vector<DryPlanes>& rooms, const glm::dvec3& position);

} // namespace seaglass
