// What stands nearest in each cell of pixels, so that rays pass over empty ones at once; and in which tiles the plane is
// seen, so that rays are followed where somebody looks.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"
#include "cells.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = cellsBinding, std430) buffer Cells {
    uint cells[];
};
layout(set = 0, binding = tilesBinding, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

#include "depth_quads.glsl"

// Whether lookups that waves bend may reach what stands before the plane here.
bool planeBehind(const MirrorBlock mirror, ivec2 first) {
    ivec2 last = min(first + (1 << cellShift), regionSize(mirror));
    return leastHeightAtInfinity(mirror, vec2(first), vec2(last - first)) < 0.0;
}

void main() {
    MirrorBlock mirror = storedMirror;
    int index = int(gl_GlobalInvocationID.x);
    if (index >= cellCount(mirror)) return;
    int across = squaresAcross(mirror, cellShift);
    ivec2 first = ivec2(index % across, index / across) << cellShift;
    ivec2 last = min(first + (1 << cellShift), regionSize(mirror));
    bool planeSeen = false;
    uint nearest = noKey;
    vec2 perTexel = perDepthTexel();
    int y = first.y;
    do {
        int x = first.x;
        do {
            vec4 depths = depthsAround(mirror, ivec2(x, y) + 1, perTexel).wzxy;
            for (int i = 0; i < 4; ++i) {
                ivec2 pixel = ivec2(x, y) + ivec2(i & 1, i >> 1);
                if (any(greaterThanEqual(pixel, last))) continue;
                bool far = isFar(mirror, depths[i]);
                bool onPlane = onOrBelowPlane(mirror, vec3(vec2(pixel) + 0.5, throughFarPlane(mirror, far, depths[i])));
                planeSeen = planeSeen || onPlane;
                nearest = far || onPlane ? nearest : max(nearest, keyFromDepth(mirror, depths[i]));
            }
            x += 2;
        } while (x < last.x);
        y += 2;
    } while (y < last.y);
    cells[index] = nearest;
    ivec2 block = first >> blockShift;
    int square = firstSquare(mirror, blockShift) + block.y * squaresAcross(mirror, blockShift) + block.x;
    if (nearest != noKey) atomicMax(cells[square], nearest);
    int tile = tileAt(mirror, tileOf(mirror, first));
    if (planeSeen || lookupsStray(mirror) && planeBehind(mirror, first)) atomicOr(tiles[tile], tileSeesPlane);
}
