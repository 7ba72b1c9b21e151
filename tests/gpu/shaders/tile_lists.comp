// Lists tiles, or with KEYS those near keys, or with TILES or COLUMNS visits those that are listed, whatever the header holds.
#version 450
#extension GL_GOOGLE_include_directive : require

// In place of mirror.glsl's, of any mirror.
#include "mirror_block.h"
#define MIRROR_GLSL
const int tilesBinding = 0;
const ivec2 size = ivec2(80, 44);

ivec2 reflectionSize(const MirrorBlock mirror) {
    return size;
}
bool lookupsStray(const MirrorBlock mirror) {
    return false;
}
#include "tiles.glsl"

layout(set = 0, binding = 1, std430) buffer Visits {
    uint visited[];   // of each pixel how often; then those elsewhere
};

void visit(ivec2 pixel) {
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size));
    atomicAdd(visited[inside ? pixel.y * size.x + pixel.x : size.x * size.y], 1u);
}

#ifdef TILES
#include "tile_list.glsl"

void main() {
    MirrorBlock mirror;
    ivec2 pixel = pixelToResolve(mirror);
    if (pixel != noPixel) visit(pixel);
}
#elif defined(COLUMNS)
#include "tile_columns.glsl"

void main() {
    MirrorBlock mirror;
    Column column = columnToVisit(mirror);
    if (column.rows == 0) return;
    int row = 0;
    do visit(column.top + ivec2(0, row)); while (++row < column.rows);
}
#else
#include "list_tile.glsl"
layout(local_size_x = 64) in;

void main() {
    MirrorBlock mirror;
    ivec2 tile = ivec2(gl_GlobalInvocationID.x % uint(tilesAcross(mirror)), gl_GlobalInvocationID.x / uint(tilesAcross(mirror)));
#ifdef KEYS
    if (tile.y < tilesDown(mirror) && keysNear(mirror, tile)) listTile(mirror, tile);
#else
    listTile(mirror, tile);
    listTileOfColumns(mirror, tile);
#endif
}
#endif
