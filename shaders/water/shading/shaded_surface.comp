// Shades what found_surface.frag found of a surface, each pixel once: a group a tile of the list.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "surface.glsl"
#include "tile_quad.glsl"

layout(set = 0, binding = shadedBinding, rgba32f) uniform writeonly image2D shadedOutput;   // in its place, of all but light

#include "surface_shading.glsl"
#include "surface_outputs.glsl"
#include "found_surface.glsl"
#include "found_tiles.glsl"
#include "shaded_pixels.glsl"

layout(set = 0, binding = foundAsideBinding) uniform usampler2D foundAside;

// Of tiles that need as much as this kernel has.
const uint listShaded = (hasReflection ? foundMirrors : 0u) | (hasRefraction ? foundSeesBed : 0u);

// What a pixel shows.
struct Found {
    bool shows;
    vec2 calm;
    vec3 position;
};

// At a depth of 0 nothing shows, and no place is that far: the nearest on the line of sight.
vec3 placeAt(vec2 pixel, float depth) {
    vec4 p = water.relativeFromFound * vec4(pixel, depth > 0.0 ? depth : 1.0, 1.0);
    return p.xyz / p.w;
}

Found foundAt(ivec2 at) {
    Found found;
    ivec2 held = clamp(at, ivec2(0), regionSize() - 1);
    float depth = texelFetch(foundDepth, held, 0).r;
    found.shows = depth > 0.0 && held == at;
    found.position = placeAt(vec2(at) + 0.5, depth);
    found.calm = found.position.xz - movedAside(texelFetch(foundAside, held, 0).r);
    return found;
}

// To what the next pixel along an axis shows, on the calm plane and in space.
struct Step {
    vec2 calm;
    vec3 position;
};

// To the one before or behind, whichever shows what is nearer on the calm plane: across a wave's edge another one shows.
Step stepBetween(Found here, Found before, Found behind) {
    Step back = Step(here.calm - before.calm, here.position - before.position);
    Step ahead = Step(behind.calm - here.calm, behind.position - here.position);
    bool isAhead = behind.shows && (!before.shows || dot(ahead.calm, ahead.calm) < dot(back.calm, back.calm));
    return isAhead ? ahead : back;
}

// Of a pixel that none beside it goes on from: over level water, to the line of sight of the one behind.
Step stepOverLevel(Found here, vec3 there) {
    vec3 sight = sightTo(there);
    float rise = abs(sight.y) > 1e-6 * length(sight) ? sight.y : 1e-6 * length(sight);
    vec3 moved = there + sight * ((here.position.y - there.y) / rise) - here.position;
    return Step(moved.xz, moved);
}

Step stepAlong(Found here, Found before, Found behind) {
    Step step = stepBetween(here, before, behind);
    if (!before.shows && !behind.shows) step = stepOverLevel(here, behind.position);
    return step;
}

// All four of its quad.
bool quadShows(ivec2 at) {
    ivec2 first = at & ~1;
    bool all4 = true;
    for (int i = 0; i < 4; ++i) all4 = all4 && foundAt(first + ivec2(i & 1, i >> 1)).shows;
    return all4;
}

// They show this water, and from the same side.
bool quadIsAlike(Found found, bool fromWater, ivec2 at, inout uint turn) {
    if (!hasWaves) return false;
    if (!mayBeInBoth && allAreShaded()) return quadShows(at);
    float side = fromWater ? -1.0 : 1.0;
    return abs(meanOfQuad(vec4(found.shows ? side : 0.0), turn).x) == 1.0;
}

// All of it but what light alone asks for: `sunSeen` and `air`.
SurfacePoint shownPoint(Found found, ivec2 at, inout uint turn) {
    Step right, down = Step(vec2(0.0), vec3(0.0));
    Found before, behind = found;
    int beside = 0;
    // To the left, the right, above and below: all share one copy of the code.
    [[dont_unroll]] do {
        before = behind;
        int aside = 2 * (beside & 1) - 1;
        behind = foundAt(at + (beside < 2 ? ivec2(aside, 0) : ivec2(0, aside)));
        if (beside == 2) right = down;
        if ((beside & 1) == 1) down = stepAlong(found, before, behind);
    } while (++beside < 4);
    SurfacePoint s;
    s.pixel = vec2(at) + 0.5;
    s.fromWater = isFromWater(s.pixel);
    s.quadIsAlike = quadIsAlike(found, s.fromWater, at, turn);
    s.footprint = footprintOf(right.calm, down.calm);
    vec2 widest = max(abs(right.calm), abs(down.calm));
    s.pixelLength = max(widest.x, widest.y);
    s.position = found.position;
    s.overPlane = found.position + vec3(0.0, globeDrop(found.calm), 0.0);
    s.height = heightOverCalm(s.overPlane);
    // The mesh's chords cut under the ball: from the air by more than waves are high.
    if (onGlobe) s.height = clamp(s.height, -farthestAside(), farthestAside());
    s.overPlane.y = calmLevel() + s.height;
    if (onGlobe) s.level = levelAt(found.calm);
    WaveGradient ofShore = WaveGradient(vec2(0.0), vec2(0.0), vec2(0.0));
    vec3 unseenOfShore = vec3(0.0);
    if (hasShore) {
        ShoreWave w = shoreWave(found.calm, s.pixelLength);
        addShore(w, ofShore);
        unseenOfShore = w.covariance;
        s.shore = shoreSeen(w);
    }
    s.calm = shownCalm(found.calm, s.footprint, found.position, s.height, cross(right.position, down.position));
    findSlopes(s, ofShore, unseenOfShore, turn);
    s.sunSeen = 1.0;
    s.air = vec4(vec3(0.0), 1.0);
    return s;
}

void main() {
    uint n = gl_WorkGroupID.y * foundGroupsPerRow + gl_WorkGroupID.x;
    bool isListed = n < header.groups[listShaded].w;
    ivec2 first = firstPixel(tiles[placeInList(listShaded, isListed ? int(n) : 0)]);
    ivec2 at = shadedPixel(first / blockSize() + placeInTile());
    Found found = foundAt(at);
    uint turn = 0u;   // of the quads
    SurfacePoint s = shownPoint(found, min(at, regionSize() - 1), turn);
    vec4 made;
    if (shadingStep == stepBed || shadingStep == stepMirror) made = stepAlone(s, turn);
    else made = shaded(s, turn);
    at = ivec2(s.pixel);   // kept no more than once meanwhile
    if (!isListed || !found.shows) return;
    if (shadingStep == stepMirror) keepMirrored(at, made);
    else if (surfaceOutput == outputShaded) imageStore(shadedColor, at, min(made, vec4(mostOfHalf)));
    else imageStore(shadedOutput, at, made);
}
