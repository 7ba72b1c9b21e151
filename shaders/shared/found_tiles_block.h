// The list of the 8 x 8 tiles of a view that show a surface, for GLSL and C++ alike: its head, then a tile an
// entry.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

const uint foundGroupsPerRow = 32768u; // a group a tile, in rows that every device takes

struct FoundTilesHeader {
    uvec4 groups; // VkDispatchIndirectCommand, and how many tiles are listed
};

#ifdef __cplusplus
}
#endif
