// The lists of the tiles of a view that show a surface: of 8 x 8 blocks each.
//
// Behind the header lie the lists, each with room for all tiles; then what each tile needs, 0 where it shows no surface, else
// its list and 1; then, for each 64 tiles in a row, how many of them each list gets.
#ifndef FOUND_TILES_GLSL
#define FOUND_TILES_GLSL

#include "found_tiles_block.h"
#include "body.glsl"
#include "shading_block.glsl"

ivec2 tileSize() {
    return 8 * blockSize();
}

layout(set = 0, binding = foundTilesBinding, std430) buffer Tiles {
    FoundTilesHeader header;
    uint tiles[];
};

ivec2 tilesAcross() {
    return (regionSize() + tileSize() - 1) / tileSize();
}

int tileCount() {
    ivec2 across = tilesAcross();
    return across.x * across.y;
}

int placeInList(uint list, int n) {
    return int(list) * tileCount() + n;
}

int placeOfNeeds(int tile) {
    return placeInList(foundLists, tile);
}

int placeOfCounts(int group) {
    return placeOfNeeds(tileCount()) + int(foundLists) * group;
}

// A tile of a list: its first pixel.
uint heldTile(int tile) {
    int across = tilesAcross().x;
    return uint(tile % across) | uint(tile / across) << 16;
}

ivec2 firstPixel(uint held) {
    return ivec2(held & 0xffffu, held >> 16) * tileSize();
}

#endif
