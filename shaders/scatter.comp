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

// What stays the same for all keys of an invocation. CPU devices load uniforms anew in each turn of a loop.
struct Grid {
    vec2 size;          // of the region [pixel]
    int keyShift;
    int keysAcross;
    int tileShift;      // from the region's pixels
    int tilesAcross;
    float depthSign;
    float far;          // signed
    float infinity;
    uint flipped;       // by keyFromDepth()
};

Grid gridOfKeys() {
    return Grid(vec2(region.zw), keyShift, keyGrid().x, tileShift + pixelShift, tilesAcross(), depthSign,
                depthSign * farDepth, infinityDepth, keyFromDepth(0.0));
}

int keyTile = -1;

void scatter(Grid grid, vec4 target, bool far) {
    vec3 point = target.xyz / target.w;
    bool inside = all(greaterThanEqual(point.xy, vec2(0.0))) && all(lessThan(point.xy, grid.size));
    if (far || !(target.w > 0.0) || !(point.z > 0.0 && point.z <= 1.0) || !inside) return;
    ivec2 pixel = ivec2(point.xy);
    ivec2 cell = pixel >> grid.keyShift;
    atomicMax(keys[cell.y * grid.keysAcross + cell.x], floatBitsToUint(point.z) ^ grid.flipped);
    ivec2 inTile = pixel >> grid.tileShift;
    int tile = inTile.y * grid.tilesAcross + inTile.x;
    if (tile != keyTile) atomicOr(tiles[tile], tileHasKeys);
    keyTile = tile;
}

bool isFar(Grid grid, float depth) {
    return grid.depthSign * depth <= grid.far;
}

#ifdef COARSE
// Of a cell's pixels the nearest stands for all, since any fixed one would lose what is thin; the farthest tells whether
// the plane is seen, which goes on behind a far plane.
bool scatterCells(Grid grid, ivec2 first, int rows) {
    vec4 above = aboveRow();
    mat4 mirror = screenMirror;
    ivec2 origin = region.xy;
    ivec2 last = region.zw - 1;
    int edge = 1 << grid.keyShift;
    bool planeSeen = false;
    for (int row = 0; row < rows && first.y <= last.y; ++row) {
        vec4 nearest, farthest;
        for (int i = 0; i < edge * edge; ++i) {
            ivec2 pixel = min(first + ivec2(i & (edge - 1), i >> grid.keyShift), last);
            float depth = texelFetch(sceneDepth, origin + pixel, 0).r;
            vec4 here = vec4(vec2(pixel) + 0.5, depth, 1.0);
            float ahead = grid.depthSign * depth;
            if (i == 0 || ahead > grid.depthSign * nearest.z) nearest = here;
            if (i == 0 || ahead < grid.depthSign * farthest.z) farthest = here;
        }
        bool far = isFar(grid, nearest.z);
        if (isFar(grid, farthest.z)) farthest.z = grid.infinity;
        if (far || dot(above, nearest) > 0.0) scatter(grid, mirror * nearest, far);
        planeSeen = planeSeen || dot(above, farthest) <= 0.0;
        first.y += edge;
    }
    return planeSeen;
}
#else
// All that a pixel needs is affine in (x, y, depth): only the depth's share is left for the loop.
bool scatterPixels(Grid grid, ivec2 first, int rows) {
    vec4 corner = vec4(vec2(first) + 0.5, 0.0, 1.0);
    vec4 target = screenMirror * corner;
    vec4 targetPerRow = screenMirror[1];
    vec4 targetPerDepth = screenMirror[2];
    vec4 perPixel = aboveRow();
    float above = dot(perPixel, corner);
    ivec2 pixel = region.xy + first;
    bool planeSeen = false;
    rows = min(rows, region.w - first.y);
    for (int row = 0; row < rows; ++row) {
        float depth = texelFetch(sceneDepth, pixel, 0).r;
        bool far = isFar(grid, depth);
        if (above + perPixel.z * (far ? grid.infinity : depth) <= 0.0)
            planeSeen = true;
        else
            scatter(grid, target + targetPerDepth * depth, far);
        target += targetPerRow;
        above += perPixel.y;
        ++pixel.y;
    }
    return planeSeen;
}
#endif

void main() {
    int rows = (tileEdge << pixelShift) >> keyShift;
    ivec2 first = (ivec2(gl_GlobalInvocationID.xy) * ivec2(1, rows)) << keyShift;
    if (first.x >= region.z) return;
#ifdef COARSE
    bool planeSeen = scatterCells(gridOfKeys(), first, rows);
#else
    bool planeSeen = scatterPixels(gridOfKeys(), first, rows);
#endif
    if (planeSeen) atomicOr(tiles[tileAt(first >> (tileShift + pixelShift))], tileSeesPlane);
}
