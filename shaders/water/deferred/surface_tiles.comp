// Lists the tiles of a view that show a surface. The order of the list is any; what is shaded of a tile does not depend on it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "water_bindings.h"
#include "body.glsl"
#include "found_tiles_block.h"
#include "found_surface.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;
layout(set = 0, binding = foundTilesBinding, std430) buffer Tiles {
    FoundTilesHeader header;
    uint tiles[];
};

bool showsSurface(ivec2 tile) {
    ivec2 last = foundSize() - 1;
    for (int i = 0; i < 64; ++i)
        if (texelFetch(foundDepth, min(tile * 8 + ivec2(i & 7, i >> 3), last), 0).r > 0.0) return true;
    return false;
}

void main() {
    ivec2 count = (foundSize() + 7) / 8;
    int i = int(gl_GlobalInvocationID.x);
    if (i == 0) header.groups.z = 1u;
    if (i >= count.x * count.y) return;
    ivec2 tile = ivec2(i % count.x, i / count.x);
    if (!showsSurface(tile)) return;
    uint n = atomicAdd(header.groups.w, 1u);
    if (n >= uint(count.x * count.y)) return;   // what the header held before must not lead past the list's end
    atomicMax(header.groups.x, min(n + 1u, foundGroupsPerRow));
    atomicMax(header.groups.y, n / foundGroupsPerRow + 1u);
    tiles[n] = uint(tile.x) | uint(tile.y) << 16;
}
