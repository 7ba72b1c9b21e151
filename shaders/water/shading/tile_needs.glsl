// What the shading of a tile may do without: a reflection whose rays from there meet nothing, and a bed where the rays that the
// surface bends meet none. Both are told by a box around all that there is in the picture, and by how far slopes turn rays.
#ifndef TILE_NEEDS_GLSL
#define TILE_NEEDS_GLSL

#include "found_tiles.glsl"
#include "surface_tiles_constants.h"
#include "reflection_info.glsl"
#include "turns.glsl"

layout(set = 0, binding = reflectionColorBinding) uniform sampler2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding) uniform sampler2D reflectionInfo;

// Whether the reflection holds something in the tile, which is as wide as so many whole texels.
bool mirrorsScene(ivec2 first) {
    int scale = clamp(int(water.reflectionScale), 1, 8);
    ivec2 across = tileSize() / scale;
    ivec2 last = textureSize(reflectionInfo, 0) - 1;
    for (int i = 0; i < across.x * across.y; ++i)
        if (infoIsHit(texelFetch(reflectionInfo, min(first / scale + ivec2(i % across.x, i / across.x), last), 0).r)) return true;
    return false;
}

// Slopes are taken to lean by no more: four deviations of all that there are.
float steepest() {
    return 4.0 * slopeDeviation();
}

struct Box {
    vec2 low, high;   // [pixel]
};

bool isEmpty(uvec4 held) {
    return held.z == 0u;
}

Box boxOf(uvec4 held, float margin) {
    return Box(vec2(~held.xy) - margin, vec2(held.zw) + margin);
}

// Of homogeneous pixels, how far beyond each side of a box: left, right, above, below. Negative: on the box's side of it.
vec4 beyondSides(Box box, vec3 p) {
    return vec4(box.low * p.z - p.xy, p.xy - box.high * p.z).xzyw;
}

// By which sides the whole tile is.
bvec4 tileBeyond(Box box, ivec2 first) {
    vec2 low = vec2(first), high = low + vec2(tileSize());
    return greaterThan(vec4(box.low.x - high.x, low.x - box.high.x, box.low.y - high.y, low.y - box.high.y), vec4(0.0));
}

vec3 sightThrough(vec2 pixel) {
    return normalize(sightTo(pointAt(pixel, 0.5)));
}

vec3 towardsPixel(vec3 direction) {
    return homogeneousPerMetre(direction).xyw;
}

// A flat mirror shows a ray's goal where its own line of sight goes on; a facet turns that by twice as much as it leans. Rays
// stay beyond a side of the box where both ends of their way on the screen do. Facets that lean every way stand for all.
bool mayMirror(ivec2 first) {
    if (!sortsMirrors) return hasReflection;
    if (isEmpty(header.mirrored)) return false;
    // A texel of a mip holds what lies within 1.5 of its widths, and is read together with the next.
    float blurred = 2.5 * exp2(float(textureQueryLevels(reflectionColor) - 1)) * water.reflectionScale;
    Box box = boxOf(header.mirrored, blurred + float(tileSize().x) + 8.0);
    bvec4 beyond = tileBeyond(box, first);
    vec3 sight = sightThrough(vec2(first) + 0.5 * vec2(tileSize()));
    for (int i = 0; i < 8; ++i) {
        vec2 lean = steepest() * cosineSine(0.125 * float(i));
        vec3 ray = reflect(sight, normalize(vec3(lean.x, 1.0, lean.y)));
        vec3 there = towardsPixel(vec3(ray.x, -abs(ray.y), ray.z));
        if (there.z >= 0.0) beyond = bvec4(uvec4(beyond) & uvec4(greaterThanEqual(beyondSides(box, there), vec4(0.0))));
    }
    return !any(beyond);
}

// A bent ray runs between the line of sight and straight into the facet: on the screen, from the pixel towards where that goes.
bool maySeeBed(ivec2 first) {
    if (!sortsBed) return hasRefraction;
    if (isEmpty(header.behind)) return false;
    Box box = boxOf(header.behind, 8.0);
    mat4 rows = pixelRows();
    vec3 sides[4] = vec3[](box.low.x * rows[3].xyz - rows[0].xyz, rows[0].xyz - box.high.x * rows[3].xyz,
                           box.low.y * rows[3].xyz - rows[1].xyz, rows[1].xyz - box.high.y * rows[3].xyz);
    bvec4 beyond = tileBeyond(box, first);
    for (int i = 0; i < 4; ++i)
        if (beyond[i] && -sides[i].y >= steepest() * length(sides[i].xz)) return false;
    return true;
}

#endif
