// Adds tiles to the lists. Needs tiles.glsl and the buffer Tiles.

// Of an empty list; by one invocation.
void beginLists() {
    header.resolveGroups.z = header.columnGroups.z = 1u;
}

void listTile(ivec2 tile) {
    uint n = atomicAdd(header.resolveGroups.w, 1u);
    atomicMax(header.resolveGroups.x, min(n + 1u, groupsPerRow));
    atomicMax(header.resolveGroups.y, n / groupsPerRow + 1u);
    tiles[tilesAcross() * tilesDown() + int(n)] = packedTile(tile);
}

void listTileOfColumns(ivec2 tile) {
    uint n = atomicAdd(header.columnGroups.w, 1u);
    uint group = n / tilesPerColumnGroup;
    atomicMax(header.columnGroups.x, min(group + 1u, groupsPerRow));
    atomicMax(header.columnGroups.y, group / groupsPerRow + 1u);
    tiles[2 * tilesAcross() * tilesDown() - 1 - int(n)] = packedTile(tile);
}
