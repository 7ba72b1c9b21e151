// Sorts the tiles that are looked up into two lists: those with keys in or around them, and the rest. The order within
// a list is any; what is computed of a tile does not depend on it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = 1, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

bool keysNear(ivec2 tile) {
    ivec2 low = max(tile - 1, ivec2(0));
    ivec2 high = min(tile + 1, ivec2(tilesAcross(), tilesDown()) - 1);
    uint flags = 0u;
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) flags |= tiles[tileAt(ivec2(x, y))];
    return (flags & tileHasKeys) != 0u;
}

void main() {
    loadMirror();
    int count = tilesAcross() * tilesDown();
    int index = int(gl_GlobalInvocationID.x);
    if (index == 0) header.resolveGroups.z = header.emptyGroups.z = 1u;
    if (index >= count) return;
    ivec2 tile = ivec2(index % tilesAcross(), index / tilesAcross());
    if (!lookedUp(tile, tiles[index])) return;
    if (keysNear(tile)) {
        uint n = atomicAdd(header.resolveGroups.w, 1u);
        atomicMax(header.resolveGroups.x, min(n + 1u, groupsPerRow));
        atomicMax(header.resolveGroups.y, n / groupsPerRow + 1u);
        tiles[count + int(n)] = packedTile(tile);
    } else {
        uint n = atomicAdd(header.emptyGroups.w, 1u);
        uint group = n / emptyTilesPerGroup;
        atomicMax(header.emptyGroups.x, min(group + 1u, groupsPerRow));
        atomicMax(header.emptyGroups.y, group / groupsPerRow + 1u);
        tiles[2 * count - 1 - int(n)] = packedTile(tile);
    }
}
