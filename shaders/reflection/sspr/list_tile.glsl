// Adds tiles to the lists. Needs tiles.glsl and the buffer Tiles.

// Of an empty list; by one invocation.
void beginLists() {
    header.resolveGroups.z = header.columnGroups.z = 1u;
}

// Each tile is listed once, so that the lists end where they meet; what a header held before must not lead past that.
bool listHolds(uint n) {
    return n < tileCount();
}

void listTile(ivec2 tile) {
    uint n = atomicAdd(header.resolveGroups.w, 1u);
    if (!listHolds(n)) return;
    atomicMax(header.resolveGroups.x, min(n + 1u, groupsPerRow));
    atomicMax(header.resolveGroups.y, n / groupsPerRow + 1u);
    tiles[tileCount() + n] = packedTile(tile);
}

void listTileOfColumns(ivec2 tile) {
    uint n = atomicAdd(header.columnGroups.w, 1u);
    if (!listHolds(n)) return;
    uint group = n / tilesPerColumnGroup;
    atomicMax(header.columnGroups.x, min(group + 1u, groupsPerRow));
    atomicMax(header.columnGroups.y, group / groupsPerRow + 1u);
    tiles[2u * tileCount() - 1u - n] = packedTile(tile);
}
