// SSPR, first pass: every scene pixel above the plane leaves its mirrored depth where the plane would show it. Only
// depth is stored, since the mirror is an involution and leads back to the source; atomicMax commutes, so the result
// does not depend on the order of the invocations. Tiles are told where the plane is seen and where keys fell, so that
// the resolve runs where there is something to resolve.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"

// An invocation takes a column of keys of one tile.
layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) buffer Keys {
    uint keys[];
};
layout(set = 0, binding = 3, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

bool nearer(float a, float b) {
    return depthSign * (a - b) > 0.0;
}

#ifdef COARSE
struct Sample {
    ivec2 pixel;
    float depth;
};

// Of a cell's pixels the nearest stands for all, since any fixed one would lose what is thin; the farthest tells whether
// the plane is seen.
void sampleCell(ivec2 first, out Sample nearest, out Sample farthest) {
    int edge = 1 << keyShift;
    for (int i = 0; i < edge * edge; ++i) {
        ivec2 pixel = min(first + ivec2(i & (edge - 1), i >> keyShift), region.zw - 1);
        Sample here = Sample(pixel, texelFetch(sceneDepth, region.xy + pixel, 0).r);
        if (i == 0 || nearer(here.depth, nearest.depth)) nearest = here;
        if (i == 0 || nearer(farthest.depth, here.depth)) farthest = here;
    }
}

// The plane goes on behind a far plane.
vec3 screenPoint(Sample s) {
    return vec3(vec2(s.pixel) + 0.5, isFar(s.depth) ? infinityDepth : s.depth);
}
#endif

// What stays the same for all keys of an invocation.
struct Grid {
    int keysAcross;
    int tilesAcross;
    int tileShift;   // from the region's pixels
};

int keyTile = -1;

void scatter(Grid grid, vec4 target, bool far) {
    vec3 point = target.xyz / target.w;
    if (far || !(target.w > 0.0) || !(point.z > 0.0 && point.z <= 1.0) || !insideRegion(point.xy)) return;
    ivec2 pixel = ivec2(point.xy);
    ivec2 cell = pixel >> keyShift;
    atomicMax(keys[cell.y * grid.keysAcross + cell.x], keyFromDepth(point.z));
    ivec2 inTile = pixel >> grid.tileShift;
    int tile = inTile.y * grid.tilesAcross + inTile.x;
    if (tile != keyTile) atomicOr(tiles[tile], tileHasKeys);
    keyTile = tile;
}

void main() {
    int rows = (tileEdge << pixelShift) >> keyShift;
    ivec2 first = (ivec2(gl_GlobalInvocationID.xy) * ivec2(1, rows)) << keyShift;
    if (first.x >= region.z) return;
    Grid grid = Grid(keyGrid().x, tilesAcross(), tileShift + pixelShift);
    bool planeSeen = false;
#ifdef COARSE
    for (int row = 0; row < rows && first.y + (row << keyShift) < region.w; ++row) {
        Sample nearest, farthest;
        sampleCell(first + ivec2(0, (row << keyShift)), nearest, farthest);
        vec3 p = screenPoint(nearest);
        if (!onOrBelowPlane(p)) scatter(grid, screenMirror * vec4(p, 1.0), isFar(nearest.depth));
        if (onOrBelowPlane(screenPoint(farthest))) planeSeen = true;
    }
#else
    // All of these are affine in (x, y, depth): only the depth's share is left for the loop.
    vec4 corner = vec4(vec2(first) + 0.5, 0.0, 1.0);
    vec4 target = screenMirror * corner;
    float height = dot(heightRow, corner);
    float weight = dot(weightRow, corner);
    rows = min(rows, region.w - first.y);
    for (int row = 0; row < rows; ++row) {
        float depth = texelFetch(sceneDepth, region.xy + first + ivec2(0, row), 0).r;
        bool far = isFar(depth);
        float reach = far ? infinityDepth : depth;
        if (onOrBelowPlane(height + heightRow.z * reach, weight + weightRow.z * reach))
            planeSeen = true;
        else
            scatter(grid, target + screenMirror[2] * depth, far);
        target += screenMirror[1];
        height += heightRow.y;
        weight += weightRow.y;
    }
#endif
    if (planeSeen) atomicOr(tiles[tileAt(first >> grid.tileShift)], tileSeesPlane);
}
