// Tiles of 8 x 8 pixels of a reflection, and the start of their buffer: reflection/sspr/tiles.h.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

const int tileShift = 3;
const int tileEdge = 1 << tileShift;

// Flags of a tile.
const uint tileSeesPlane = 1u;
const uint tileHasKeys = 2u;

// Lists of tiles are dispatched indirectly, a group a tile or eight tiles with an invocation a column, in
// rows of groups that every device takes.
const uint groupsPerRow = 32768u;
const uint tilesPerColumnGroup = 8u;

// A flag for each tile follows, then the array of both lists, which grow from its ends.
struct TileHeader {
    uvec4 resolveGroups; // a group a tile: VkDispatchIndirectCommand, and how many tiles there are
    uvec4 columnGroups;  // tilesPerColumnGroup a group
};

#ifdef __cplusplus
}
#endif
