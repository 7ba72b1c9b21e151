// Tiles of 8 x 8 pixels of the reflection: reflection/tiles.h. Needs mirror.glsl.

const int tileShift = 3;
const int tileEdge = 1 << tileShift;
const uint tileSeesPlane = 1u;
const uint tileHasKeys = 2u;

// A list of tiles is dispatched indirectly, a group a tile, in rows that every device takes.
const uint groupsPerRow = 32768u;

// Two lists grow from both ends of one array behind the tiles' flags: tiles to resolve, and tiles that no key is near.
struct TileHeader {
    uvec4 resolveGroups;   // VkDispatchIndirectCommand, and how many there are
    uvec4 emptyGroups;
};

// Flags of tiles that shading looks up. What is mirrored behind things that stand before the plane is seen only by rays
// that waves bend there.
uint lookedUp() {
    return tileSeesPlane | (bent ? tileHasKeys : 0u);
}

int tilesAcross() {
    return (imageSize().x + tileEdge - 1) >> tileShift;
}

int tilesDown() {
    return (imageSize().y + tileEdge - 1) >> tileShift;
}

int tileAt(ivec2 tile) {
    return tile.y * tilesAcross() + tile.x;
}

uint packedTile(ivec2 tile) {
    return uint(tile.x) | uint(tile.y) << 16;
}

ivec2 unpackedTile(uint tile) {
    return ivec2(tile & 0xffffu, tile >> 16);
}
