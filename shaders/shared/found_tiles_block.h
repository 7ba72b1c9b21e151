// The tiles of a view that show a surface, in lists by what their shading needs, for GLSL and C++ alike: a
// head, then what found_tiles.glsl says.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

const uint foundGroupsPerRow = 32768u; // a group a tile, in rows that every device takes
const uint foundLists = 4u;            // numbered by what is needed:
const uint foundMirrors = 1u;          // the reflection of the scene
const uint foundSeesBed = 2u;          // what lies under the surface

struct FoundTilesHeader {
    uvec4 groups[foundLists]; // VkDispatchIndirectCommand of each, and how many tiles it holds
    uvec4 mirrored; // around what the reflection holds: ~least x and y, most x and y [pixel]; 0: nothing
    uvec4 behind;   // likewise around all of the scene but what is endlessly far
};

#ifdef __cplusplus
}
#endif
