// The buffer of tiles, to shaders that add to its lists.
#ifndef LIST_TILE_GLSL
#define LIST_TILE_GLSL

#include "tiles.glsl"

layout(set = 0, binding = tilesBinding, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

// Whether a tile or one around it has keys.
bool keysNear(const MirrorBlock mirror, ivec2 tile) {
    ivec2 low = max(tile - 1, ivec2(0));
    ivec2 high = min(tile + 1, ivec2(tilesAcross(mirror), tilesDown(mirror)) - 1);
    uint flags = 0u;
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) flags |= tiles[tileAt(mirror, ivec2(x, y))];
    return (flags & tileHasKeys) != 0u;
}

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
