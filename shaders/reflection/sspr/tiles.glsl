// Tiles of 8 x 8 pixels of the reflection: reflection/sspr/tiles.h.
#ifndef TILES_GLSL
#define TILES_GLSL

#include "mirror.glsl"
#include "tiles_block.h"

int tilesAcross(const MirrorBlock mirror) {
    return (reflectionSize(mirror).x + tileEdge - 1) >> tileShift;
}

int tilesDown(const MirrorBlock mirror) {
    return (reflectionSize(mirror).y + tileEdge - 1) >> tileShift;
}

uint tileCount(const MirrorBlock mirror) {
    return uint(tilesAcross(mirror) * tilesDown(mirror));
}

int tileAt(const MirrorBlock mirror, ivec2 tile) {
    return tile.y * tilesAcross(mirror) + tile.x;
}

// Pixels of the region to a tile, each way, and the tile that one of them lies in.
int tilePixels(const MirrorBlock mirror) {
    return tileEdge << mirror.pixelShift;
}

ivec2 tileOf(const MirrorBlock mirror, ivec2 pixel) {
    return pixel >> (tileShift + mirror.pixelShift);
}

uint packedTile(ivec2 tile) {
    return uint(tile.x) | uint(tile.y) << 16;
}

// Whether shading looks a tile with these flags up, or a pixel beside it. What is mirrored behind things that stand before
// the plane is seen only by rays that waves bend there.
bool lookedUp(const MirrorBlock mirror, ivec2 tile, uint flags) {
    ivec2 low = tile * tileEdge - 1 << mirror.pixelShift;
    ivec2 high = (tile + 1) * tileEdge + 1 << mirror.pixelShift;
    bool sees = (flags & (tileSeesPlane | (lookupsStray(mirror) ? tileHasKeys : 0u))) != 0u;
    return sees && all(lessThan(low, mirror.shown.zw)) && all(greaterThan(high, mirror.shown.xy));
}

ivec2 unpackedTile(uint tile) {
    return ivec2(tile & 0xffffu, tile >> 16);
}

#endif
