// The screen mirror, and what pixels, keys and depths are to it: reflection/core/mirror.h.
#ifndef MIRROR_GLSL
#define MIRROR_GLSL

#include "mirror_block.h"
#include "reflection_bindings.h"
#include "sight_line.glsl"
#include "texel_at.glsl"

// main() loads it once and hands it on: CPU devices load uniforms anew at each use and in each turn of a loop.
layout(set = 0, binding = mirrorBinding, std140) uniform Mirror {
    MirrorBlock storedMirror;
};

ivec2 regionSize(const MirrorBlock mirror) {
    return mirror.region.zw;
}

bool beyondRegion(const MirrorBlock mirror, ivec2 pixel) {
    return any(greaterThanEqual(pixel, regionSize(mirror)));
}

bool insideRegion(const MirrorBlock mirror, vec2 point) {
    return all(greaterThanEqual(point, vec2(0.0))) && all(lessThan(point, vec2(regionSize(mirror))));
}

// The pixel of the region that a point falls in, or else the nearest.
ivec2 regionPixel(const MirrorBlock mirror, vec2 point) {
    return texelAt(point, regionSize(mirror) - 1);
}

// Where the scene's images have a pixel of the region.
ivec2 sceneTexel(const MirrorBlock mirror, ivec2 pixel) {
    return mirror.region.xy + pixel;
}

// Pixels of the region to one of the reflection, and to one key, each way.
float pixelEdge(const MirrorBlock mirror) {
    return float(1 << mirror.pixelShift);
}
int keyEdge(const MirrorBlock mirror) {
    return 1 << mirror.keyShift;
}

// The reflection's pixel, and the key's cell, in which a pixel of the region lies.
ivec2 reflectionPixel(const MirrorBlock mirror, ivec2 pixel) {
    return pixel >> mirror.pixelShift;
}
ivec2 keyCell(const MirrorBlock mirror, ivec2 pixel) {
    return pixel >> mirror.keyShift;
}

// The reflection's pixels, and its keys'.
ivec2 reflectionSize(const MirrorBlock mirror) {
    return reflectionPixel(mirror, regionSize(mirror) + (1 << mirror.pixelShift) - 1);
}

ivec2 keyGrid(const MirrorBlock mirror) {
    return keyCell(mirror, regionSize(mirror) + keyEdge(mirror) - 1);
}

// The middle of a pixel of the reflection, in the region's pixels.
vec2 middleOf(const MirrorBlock mirror, ivec2 imagePixel) {
    return (vec2(imagePixel) + 0.5) * pixelEdge(mirror);
}

const uint noKey = 0u;

// Relative to the eye, homogeneous; and what a pixel to the right adds to that, and a depth of 1.
vec4 homogeneousPoint(const MirrorBlock mirror, vec4 screenPoint) {
    return mirror.relativeFromPixel * screenPoint;
}
vec4 homogeneousPerColumn(const MirrorBlock mirror) {
    return mirror.relativeFromPixel[0];
}
vec4 homogeneousPerDepth(const MirrorBlock mirror) {
    return mirror.relativeFromPixel[2];
}

// Relative to the eye.
vec3 unprojected(const MirrorBlock mirror, vec3 screenPoint) {
    vec4 p = homogeneousPoint(mirror, vec4(screenPoint, 1.0));
    return p.xyz / p.w;
}

// The scene's screen point that the plane shows at one of the mirror's pixels and depths.
vec4 sourcePoint(const MirrorBlock mirror, vec2 q, float mirroredDepth) {
    return mirror.sceneFromPixel * vec4(q, mirroredDepth, 1.0);
}

// Whether lookups stray from where the mirror shows.
bool lookupsStray(const MirrorBlock mirror) {
    return mirror.bent != 0u;
}

// Heights under which a point counts as lying on the plane: what a depth buffer can no longer tell apart, 1 mm and what
// contactPerMetre says for each metre of distance, 20 micrometres or a step of the depth's format. Both sides of height <
// contact are linear in a screen point once they are multiplied by its weight, and so tell of points at infinity too:
// below the plane's horizon or above it.
vec4 aboveRow(const MirrorBlock mirror) {
    return mirror.heightRow - 1e-3 * mirror.weightRow - vec4(0.0, 0.0, 0.0, mirror.contactPerMetre);
}

// The screen point at the far end of a line of sight.
vec4 atInfinity(const MirrorBlock mirror, vec2 point) {
    return vec4(point, mirror.infinityDepth, 1.0);
}

// By which distances relative to the eye are to be divided, of a screen point; not positive behind the camera.
float weightOf(const MirrorBlock mirror, vec4 point) {
    return dot(mirror.weightRow, point);
}

// Above the plane [m], of a screen point.
float heightOf(const MirrorBlock mirror, vec4 point) {
    return dot(mirror.heightRow, point) / weightOf(mirror, point);
}

// Whose product with a screen point tells how much higher than `height` it is, times its weight.
vec4 rowOver(const MirrorBlock mirror, float height) {
    return mirror.heightRow - height * mirror.weightRow;
}

// To a factor, of the far end of a line of sight: negative under the plane's horizon.
float heightAtInfinity(const MirrorBlock mirror, vec2 point) {
    return dot(mirror.heightRow, atInfinity(mirror, point));
}

// The least of that in a rectangle.
float leastHeightAtInfinity(const MirrorBlock mirror, vec2 corner, vec2 size) {
    vec4 row = mirror.heightRow;
    return dot(row, atInfinity(mirror, corner)) + min(row.x * size.x, 0.0) + min(row.y * size.y, 0.0);
}

// What each pixel down adds to it.
float heightAtInfinityPerRow(const MirrorBlock mirror) {
    return mirror.heightRow.y;
}

// Towards the eye's side.
vec3 planeNormal(const MirrorBlock mirror) {
    return mirror.plane.xyz;
}

// Above the plane [m], of a point relative to the eye.
float heightOver(const MirrorBlock mirror, vec3 point) {
    return dot(planeNormal(mirror), point) + mirror.plane.w;
}

bool onOrBelowPlane(const MirrorBlock mirror, vec3 screenPoint) {
    return dot(aboveRow(mirror), vec4(screenPoint, 1.0)) <= 0.0;
}

// Deeper under the plane than it is told apart.
bool wellBelowPlane(const MirrorBlock mirror, vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(mirror.heightRow, p) < -(1e-3 * weightOf(mirror, p) + mirror.contactPerMetre);
}

// 1 where the nearer depth is the greater, else -1.
float depthSign(const MirrorBlock mirror) {
    return mirror.depthSign;
}

bool nearerIsGreater(const MirrorBlock mirror) {
    return mirror.depthSign > 0.0;
}

// Greater is nearer, whichever way depth runs; and back.
float signedDepth(const MirrorBlock mirror, float depth) {
    return mirror.depthSign * depth;
}
vec4 signedDepths(const MirrorBlock mirror, vec4 depths) {
    return mirror.depthSign * depths;
}

// Depth less infinity's, whose first digits all that is far shares; and back.
float fromInfinity(const MirrorBlock mirror, float depth) {
    return depth - mirror.infinityDepth;
}
vec4 allFromInfinity(const MirrorBlock mirror, vec4 depths) {
    return depths - mirror.infinityDepth;
}
float depthFromInfinity(const MirrorBlock mirror, float off) {
    return off + mirror.infinityDepth;
}

bool isFar(const MirrorBlock mirror, float depth) {
    return signedDepth(mirror, depth - mirror.farDepth) <= 0.0;
}

// How deep a pixel lets the plane be seen, which goes on behind a far plane.
float throughFarPlane(const MirrorBlock mirror, bool far, float depth) {
    return far ? mirror.infinityDepth : depth;
}

// Along the line of sight, from the eye or from infinity, that a place relative to the eye lies on; of any length.
vec3 sightAt(const MirrorBlock mirror, vec3 place) {
    return alongSight(mirror.relativeFromPixel, vec4(place, 1.0), mirror.depthSign);
}

// The line of sight through a point of a picture, whose points a matrix turns into those relative to the eye.
SightLine sightThrough(const MirrorBlock mirror, mat4 relativeFromPixels, vec2 point) {
    return sightLine(relativeFromPixels, point, mirror.plane, mirror.depthSign);
}

// The same of the region.
SightLine sightThrough(const MirrorBlock mirror, vec2 point) {
    return sightThrough(mirror, mirror.relativeFromPixel, point);
}

// Positive floats order like their bits; the nearest mirrored point must win an atomicMax whichever way depth runs.
uint keyFromDepth(const MirrorBlock mirror, float depth) {
    uint bits = floatBitsToUint(depth);
    return nearerIsGreater(mirror) ? bits : ~bits;
}

float depthFromKey(const MirrorBlock mirror, uint key) {
    return uintBitsToFloat(nearerIsGreater(mirror) ? key : ~key);
}

#endif
