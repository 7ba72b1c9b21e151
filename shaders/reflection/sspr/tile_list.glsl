// Which pixel an invocation of an indirect dispatch over the list of tiles in the buffer Tiles is for.
#ifndef TILE_LIST_GLSL
#define TILE_LIST_GLSL

#include "listed_tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

const ivec2 noPixel = ivec2(-1);

// noPixel beyond the image and beyond the list's end.
ivec2 pixelToResolve(const MirrorBlock mirror) {
    uint n = gl_WorkGroupID.y * groupsPerRow + gl_WorkGroupID.x;
    if (n >= min(header.resolveGroups.w, tileCount(mirror))) return noPixel;
    ivec2 pixel = unpackedTile(tiles[tileCount(mirror) + n]) * tileEdge + ivec2(gl_LocalInvocationID.xy);
    return all(lessThan(pixel, reflectionSize(mirror))) ? pixel : noPixel;
}

#endif
