// Which column of a tile an invocation of an indirect dispatch over the list of columns in the buffer Tiles is for.
#ifndef TILE_COLUMNS_GLSL
#define TILE_COLUMNS_GLSL

#include "listed_tiles.glsl"

layout(local_size_x = tileEdge * tilesPerColumnGroup, local_size_y = 1) in;

struct Column {
    ivec2 top;
    int rows;   // within the image; none beyond the list's end
};

Column columnToVisit(const MirrorBlock mirror) {
    uint group = gl_WorkGroupID.y * groupsPerRow + gl_WorkGroupID.x;
    uint n = group * tilesPerColumnGroup + (gl_LocalInvocationID.x >> tileShift);
    if (n >= min(header.columnGroups.w, tileCount(mirror))) return Column(ivec2(0), 0);
    ivec2 tile = unpackedTile(tiles[2u * tileCount(mirror) - 1u - n]);
    ivec2 top = tile * tileEdge + ivec2(gl_LocalInvocationID.x & (tileEdge - 1), 0);
    ivec2 size = reflectionSize(mirror);
    return Column(top, top.x < size.x ? clamp(size.y - top.y, 0, tileEdge) : 0);
}

#endif
