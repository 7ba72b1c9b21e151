// The buffer of tiles, to shaders that add to its lists.
#ifndef LIST_TILE_GLSL
#define LIST_TILE_GLSL

#include "tiles.glsl"

layout(set = 0, binding = tilesBinding, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

// Of an empty list; by one invocation.
void beginLists() {
    header.resolveGroups.z = header.columnGroups.z = 1u;
}

// Each tile is listed once, so that the lists end where they meet; what a header held before must not lead past that.
bool listHolds(const MirrorBlock mirror, uint n) {
    return n < tileCount(mirror);
}

void listTile(const MirrorBlock mirror, ivec2 tile) {
    uint n = atomicAdd(header.resolveGroups.w, 1u);
    if (!listHolds(mirror, n)) return;
    atomicMax(header.resolveGroups.x, min(n + 1u, groupsPerRow));
    atomicMax(header.resolveGroups.y, n / groupsPerRow + 1u);
    tiles[tileCount(mirror) + n] = packedTile(tile);
}

void listTileOfColumns(const MirrorBlock mirror, ivec2 tile) {
    uint n = atomicAdd(header.columnGroups.w, 1u);
    if (!listHolds(mirror, n)) return;
    uint group = n / tilesPerColumnGroup;
    atomicMax(header.columnGroups.x, min(group + 1u, groupsPerRow));
    atomicMax(header.columnGroups.y, group / groupsPerRow + 1u);
    tiles[2u * tileCount(mirror) - 1u - n] = packedTile(tile);
}

#endif
