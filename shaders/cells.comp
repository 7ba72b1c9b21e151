// What stands nearest in each cell of pixels, so that rays pass over empty ones at once; and in which tiles the plane is
// seen, so that rays are followed where somebody looks.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"
#include "cells.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) buffer Cells {
    uint cells[];
};
layout(set = 0, binding = 3, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

// Whether lookups that waves bend may reach what stands before the plane here.
bool planeBehind(ivec2 first) {
    ivec2 last = min(first + (1 << cellShift), region.zw);
    vec4 corner = vec4(vec2(first), infinityDepth, 1.0);
    vec2 span = vec2(last - first);
    return dot(heightRow, corner) + min(heightRow.x * span.x, 0.0) + min(heightRow.y * span.y, 0.0) < 0.0;
}

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= cellCount()) return;
    int across = squaresAcross(cellShift);
    ivec2 first = ivec2(index % across, index / across) << cellShift;
    ivec2 last = min(first + (1 << cellShift), region.zw);
    bool planeSeen = false;
    uint nearest = noKey;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            float depth = texelFetch(sceneDepth, region.xy + ivec2(x, y), 0).r;
            bool far = isFar(depth);
            bool onPlane = onOrBelowPlane(vec3(vec2(x, y) + 0.5, far ? infinityDepth : depth));
            planeSeen = planeSeen || onPlane;
            nearest = far || onPlane ? nearest : max(nearest, keyFromDepth(depth));
        }
    cells[index] = nearest;
    ivec2 block = first >> blockShift;
    if (nearest != noKey) atomicMax(cells[firstSquare(blockShift) + block.y * squaresAcross(blockShift) + block.x], nearest);
    if (planeSeen || bent && planeBehind(first)) atomicOr(tiles[tileAt(first >> (tileShift + pixelShift))], tileSeesPlane);
}
