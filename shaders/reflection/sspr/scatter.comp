// SSPR, first pass: every scene pixel above the plane leaves its mirrored depth where the plane would show it. Only
// depth is stored, since the mirror is an involution and leads back to the source; atomicMax commutes, so the result
// does not depend on the order of the invocations. Tiles are told where the plane is seen and where keys fell, so that
// the resolve runs where there is something to resolve.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"

// An invocation takes a column of one tile, two pixels wide or a key.
layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = keysBinding, std430) buffer Keys {
    uint keys[];
};
layout(set = 0, binding = tilesBinding, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

#include "depth_quads.glsl"

// Of keyGrid() and tilesAcross().
int keysAcross;
int tilesInRow;
int keyTile = -1;

void scatter(const MirrorBlock mirror, vec4 target, bool far) {
    vec3 point = target.xyz / target.w;
    if (far || !(target.w > 0.0) || !(point.z > 0.0 && point.z <= 1.0) || !insideRegion(mirror, point.xy)) return;
    ivec2 pixel = ivec2(point.xy);
    ivec2 cell = keyCell(mirror, pixel);
    atomicMax(keys[cell.y * keysAcross + cell.x], keyFromDepth(mirror, point.z));
    ivec2 inTile = tileOf(mirror, pixel);
    int tile = inTile.y * tilesInRow + inTile.x;
    if (tile != keyTile) atomicOr(tiles[tile], tileHasKeys);
    keyTile = tile;
}

#ifdef COARSE
vec4 nearerOf(const MirrorBlock mirror, vec4 a, vec4 b) {
    return signedDepth(mirror, b.z) > signedDepth(mirror, a.z) ? b : a;
}

vec4 fartherOf(const MirrorBlock mirror, vec4 a, vec4 b) {
    return signedDepth(mirror, b.z) < signedDepth(mirror, a.z) ? b : a;
}

// Of a cell's pixels the nearest stands for all, since any fixed one would lose what is thin; the farthest tells whether
// the plane is seen, which goes on behind a far plane.
bool scatterCells(const MirrorBlock mirror, ivec2 first, int rows) {
    vec4 above = aboveRow(mirror);
    ivec2 last = regionSize(mirror) - 1;
    vec2 perTexel = perDepthTexel();
    int quads = keyEdge(mirror) >> 1;
    bool planeSeen = false;
    int row = 0;
    do {
        vec4 nearest, farthest;
        for (int i = 0; i < quads * quads; ++i) {
            // Past the border, the pixels before it again.
            ivec2 corner = min(first + 2 * ivec2(i & (quads - 1), i >> (mirror.keyShift - 1)), last);
            vec4 depths = depthsAround(mirror, corner + 1, perTexel);
            vec4 own = vec4(vec2(corner) + 0.5, depths.w, 1.0);
            bvec2 goesOn = lessThan(corner, last);
            vec4 right = goesOn.x ? vec4(own.xy + vec2(1.0, 0.0), depths.z, 1.0) : own;
            vec4 below = goesOn.y ? vec4(own.xy + vec2(0.0, 1.0), depths.x, 1.0) : own;
            vec4 across = all(goesOn) ? vec4(own.xy + 1.0, depths.y, 1.0) : own;
            vec4 near = nearerOf(mirror, nearerOf(mirror, own, right), nearerOf(mirror, below, across));
            vec4 far = fartherOf(mirror, fartherOf(mirror, own, right), fartherOf(mirror, below, across));
            nearest = i == 0 ? near : nearerOf(mirror, nearest, near);
            farthest = i == 0 ? far : fartherOf(mirror, farthest, far);
        }
        bool far = isFar(mirror, nearest.z);
        farthest.z = throughFarPlane(mirror, isFar(mirror, farthest.z), farthest.z);
        if (far || dot(above, nearest) > 0.0) scatter(mirror, mirror.screenMirror * nearest, far);
        planeSeen = planeSeen || dot(above, farthest) <= 0.0;
        first.y += keyEdge(mirror);
    } while (++row < rows && first.y <= last.y);
    return planeSeen;
}
#else
float abovePerDepth;
vec4 targetPerDepth;

// All that a pixel needs is affine in (x, y, depth): only the depth's share is left for the loop.
bool scatterPixel(const MirrorBlock mirror, vec4 target, float above, float depth) {
    bool far = isFar(mirror, depth);
    bool seesPlane = above + abovePerDepth * throughFarPlane(mirror, far, depth) <= 0.0;
    if (!seesPlane) scatter(mirror, target + targetPerDepth * depth, far);
    return seesPlane;
}

bool scatterPixels(const MirrorBlock mirror, ivec2 first, int rows) {
    vec4 corner = vec4(vec2(first) + 0.5, 0.0, 1.0);
    vec4 target = mirror.screenMirror * corner;
    vec4 perColumn = mirror.screenMirror[0];
    vec4 perRow = mirror.screenMirror[1];
    targetPerDepth = mirror.screenMirror[2];
    vec4 row = aboveRow(mirror);
    abovePerDepth = row.z;
    float above = dot(row, corner);
    ivec2 last = regionSize(mirror) - 1;
    bool goesOn = first.x < last.x;
    vec2 perTexel = perDepthTexel();
    bool planeSeen = false;
    int i = 0;
    do {
        vec4 depths = depthsAround(mirror, first + 1, perTexel);
        planeSeen = scatterPixel(mirror, target, above, depths.w) || planeSeen;
        if (goesOn) planeSeen = scatterPixel(mirror, target + perColumn, above + row.x, depths.z) || planeSeen;
        if (first.y < last.y) {
            planeSeen = scatterPixel(mirror, target + perRow, above + row.y, depths.x) || planeSeen;
            if (goesOn)
                planeSeen = scatterPixel(mirror, target + perRow + perColumn, above + row.y + row.x, depths.y) || planeSeen;
        }
        target += 2.0 * perRow;
        above += 2.0 * row.y;
        first.y += 2;
        i += 2;
    } while (i < rows && first.y <= last.y);
    return planeSeen;
}
#endif

void main() {
    MirrorBlock mirror = storedMirror;
    keysAcross = keyGrid(mirror).x;
    tilesInRow = tilesAcross(mirror);
    int rows = tilePixels(mirror) >> mirror.keyShift;
    ivec2 first = ivec2(gl_GlobalInvocationID.x << max(mirror.keyShift, 1),
                        int(gl_GlobalInvocationID.y) * rows << mirror.keyShift);
    if (beyondRegion(mirror, first)) return;
#ifdef COARSE
    bool planeSeen = scatterCells(mirror, first, rows);
#else
    bool planeSeen = scatterPixels(mirror, first, rows);
#endif
    if (planeSeen) atomicOr(tiles[tileAt(mirror, tileOf(mirror, first))], tileSeesPlane);
}
