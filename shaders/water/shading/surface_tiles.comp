// Lists the tiles of a view that show a surface, by what their shading needs, in the order of rows: in three steps, as each wants
// to know what the one before found of all of the view. An invocation is a tile.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "body.glsl"
#include "found_surface.glsl"
#include "shading_block.glsl"
#include "found_tiles.glsl"
#include "turns.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;
layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;

#include "tile_needs.glsl"

bool showsSurface(ivec2 first) {
    ivec2 last = regionSize() - 1;
    for (int i = 0; i < tileSize().x * tileSize().y; ++i)
        if (texelFetch(foundDepth, min(first + ivec2(i % tileSize().x, i / tileSize().x), last), 0).r > 0.0) return true;
    return false;
}

bool showsScene(ivec2 first) {
    ivec2 last = regionSize() - 1;
    for (int i = 0; i < tileSize().x * tileSize().y; ++i) {
        ivec2 pixel = min(first + ivec2(i % tileSize().x, i / tileSize().x), last);
        if (!isFarPlane(texelFetch(sceneDepth, sceneTexel(pixel), 0).r)) return true;
    }
    return false;
}

shared uvec4 boxes[2];
shared uint counted[foundLists];
shared uint needed[64];

// The tile's pixels, as a box is held.
uvec4 boxAround(ivec2 first) {
    return uvec4(~uvec2(first), uvec2(first) + uvec2(tileSize()));
}

void growBox(int which, uvec4 by) {
    for (int i = 0; i < 4; ++i) atomicMax(boxes[which][i], by[i]);
}

void findShown(int tile, bool isTile) {
    uint lane = gl_LocalInvocationIndex;
    if (lane < 2u) boxes[lane] = uvec4(0u);
    barrier();
    ivec2 first = firstPixel(heldTile(tile));
    if (isTile) tiles[placeOfNeeds(tile)] = showsSurface(first) ? 1u : 0u;
    if (sortsMirrors && isTile && mirrorsScene(first)) growBox(0, boxAround(first));
    if (sortsBed && isTile && showsScene(first)) growBox(1, boxAround(first));
    barrier();
    if (lane >= 4u) return;
    if (sortsMirrors && boxes[0].z > 0u) atomicMax(header.mirrored[lane], boxes[0][lane]);
    if (sortsBed && boxes[1].z > 0u) atomicMax(header.behind[lane], boxes[1][lane]);
}

void findNeeds(int tile, bool isTile) {
    uint lane = gl_LocalInvocationIndex;
    if (lane < foundLists) counted[lane] = 0u;
    barrier();
    if (isTile && tiles[placeOfNeeds(tile)] > 0u) {
        ivec2 first = firstPixel(heldTile(tile));
        uint needs = (mayMirror(first) ? foundMirrors : 0u) | (maySeeBed(first) ? foundSeesBed : 0u);
        tiles[placeOfNeeds(tile)] = 1u + needs;
        atomicAdd(counted[needs], 1u);
    }
    barrier();
    if (lane < foundLists) tiles[placeOfCounts(int(gl_WorkGroupID.x)) + int(lane)] = counted[lane];
}

// What a list holds of the groups of tiles before this one.
void countBefore() {
    uint lane = gl_LocalInvocationIndex;
    if (lane < foundLists) counted[lane] = 0u;
    barrier();
    uint sums[foundLists] = uint[](0u, 0u, 0u, 0u);
    for (int group = int(lane); group < int(gl_WorkGroupID.x); group += 64)
        for (int list = 0; list < int(foundLists); ++list) sums[list] += tiles[placeOfCounts(group) + list];
    for (int list = 0; list < int(foundLists); ++list)
        if (sums[list] > 0u) atomicAdd(counted[list], sums[list]);
    barrier();
}

void writeGroups(uint list) {
    uint n = min(counted[list] + tiles[placeOfCounts(int(gl_WorkGroupID.x)) + int(list)], uint(tileCount()));
    header.groups[list] = uvec4(min(n, foundGroupsPerRow), (n + foundGroupsPerRow - 1u) / foundGroupsPerRow, 1u, n);
}

void listTiles(int tile, bool isTile) {
    uint lane = gl_LocalInvocationIndex;
    needed[lane] = isTile ? min(tiles[placeOfNeeds(tile)], foundLists) : 0u;
    countBefore();
    if (needed[lane] > 0u) {
        uint list = needed[lane] - 1u;
        uint n = counted[list];
        for (int i = 0; i < int(lane); ++i) n += needed[i] == needed[lane] ? 1u : 0u;
        if (n < uint(tileCount())) tiles[placeInList(list, int(n))] = heldTile(tile);
    }
    if (gl_WorkGroupID.x + 1u == gl_NumWorkGroups.x && lane < foundLists) writeGroups(lane);
}

void main() {
    int tile = int(gl_GlobalInvocationID.x);
    bool isTile = tile < tileCount();
    if (listingStep == 0u) findShown(tile, isTile);
    else if (listingStep == 1u) findNeeds(tile, isTile);
    else listTiles(tile, isTile);
}
