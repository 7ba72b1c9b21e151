// Tiles of 8 x 8 pixels of the reflection: reflection/tiles.h. Needs mirror.glsl.

const int tileShift = 3;
const int tileEdge = 1 << tileShift;
const uint tileSeesPlane = 1u;
const uint tileHasKeys = 2u;

// Lists of tiles are dispatched indirectly, a group a tile or eight tiles with an invocation a column, in rows of groups
// that every device takes.
const uint groupsPerRow = 32768u;
const uint tilesPerColumnGroup = 8u;

// Two lists grow from both ends of one array behind the tiles' flags.
struct TileHeader {
    uvec4 resolveGroups;   // a group a tile: VkDispatchIndirectCommand, and how many tiles there are
    uvec4 columnGroups;    // tilesPerColumnGroup a group
};

int tilesAcross() {
    return (imageSize().x + tileEdge - 1) >> tileShift;
}

int tilesDown() {
    return (imageSize().y + tileEdge - 1) >> tileShift;
}

uint tileCount() {
    return uint(tilesAcross() * tilesDown());
}

int tileAt(ivec2 tile) {
    return tile.y * tilesAcross() + tile.x;
}

uint packedTile(ivec2 tile) {
    return uint(tile.x) | uint(tile.y) << 16;
}

// Whether shading looks a tile with these flags up, or a pixel beside it. What is mirrored behind things that stand before
// the plane is seen only by rays that waves bend there.
bool lookedUp(ivec2 tile, uint flags) {
    ivec2 low = tile * tileEdge - 1 << pixelShift;
    ivec2 high = (tile + 1) * tileEdge + 1 << pixelShift;
    bool sees = (flags & (tileSeesPlane | (bent ? tileHasKeys : 0u))) != 0u;
    return sees && all(lessThan(low, shown.zw)) && all(greaterThan(high, shown.xy));
}

ivec2 unpackedTile(uint tile) {
    return ivec2(tile & 0xffffu, tile >> 16);
}
