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
using ExclusionPlanes = std::array<glm::dvec4, exclusionVolumePlanes>;

/// Null when the volumes are usable, else what is wrong with one. Fills `out`.
const char* readExclusionVolumes(const ExclusionVolume* volumes, uint32_t count,
                                 std::vector<ExclusionPlanes>& out);

/// How many the shaders look at: a power of two, so that few pipelines serve, or none.
uint32_t volumesPacked(const std::vector<ExclusionPlanes>& volumes);

/// False: none reaches into a box. True also where one comes near a corner of it.
bool mayExcludeIn(const std::vector<ExclusionPlanes>& volumes, const glm::dvec3& low, const glm::dvec3& high);

bool isExcluded(const std::vector<ExclusionPlanes>& volumes, const glm::dvec3& position);

} // namespace seaglass
