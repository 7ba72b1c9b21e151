// Lists the tiles that are looked up; with HOLES, only those in which a reflection holds pixels that nothing is known of;
// with COLUMNS, to be taken column by column.
// The order of the list is any; what is computed of a tile does not depend on it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = sortedTilesBinding, std430) readonly buffer Sorted {
    TileHeader sortedHeader;
    uint sorted[];
};
#include "list_tile.glsl"

#ifdef HOLES
layout(set = 0, binding = reflectionInfoBinding) uniform sampler2D reflectionInfo;

bool holdsUnknown(const MirrorBlock mirror, ivec2 tile) {
    ivec2 low = tile * tileEdge;
    ivec2 high = min(low + tileEdge, reflectionSize(mirror));
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            if (infoIsOpen(texelFetch(reflectionInfo, ivec2(x, y), 0).r)) return true;
    return false;
}
#else
bool holdsUnknown(const MirrorBlock mirror, ivec2 tile) {
    return true;
}
#endif

void main() {
    MirrorBlock mirror = storedMirror;
    int count = tilesAcross(mirror) * tilesDown(mirror);
    int index = int(gl_GlobalInvocationID.x);
    if (index == 0) beginLists();
    if (index >= count) return;
    ivec2 tile = ivec2(index % tilesAcross(mirror), index / tilesAcross(mirror));
    if (!lookedUp(mirror, tile, sorted[index])) return;
    if (!holdsUnknown(mirror, tile)) return;
#ifdef COLUMNS
    listTileOfColumns(mirror, tile);
#else
    listTile(mirror, tile);
#endif
}
