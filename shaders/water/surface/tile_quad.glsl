// The quad of 2 x 2 pixels that share what they find: of an 8 x 8 tile four invocations in a row. To be asked where all invocations
// go.
#ifndef TILE_QUAD_GLSL
#define TILE_QUAD_GLSL

#extension GL_KHR_shader_subgroup_basic : require
#include "surface.glsl"

layout(local_size_x = 64) in;

// Told by turns, which begin with 0: what was told before is read meanwhile.
shared vec4 ofQuads[2][64];

// Of this invocation among those of the tile.
uint indexInTile() {
    return quadsInStep ? gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID : gl_LocalInvocationIndex;
}

// Where it is in its tile.
ivec2 placeInTile() {
    uint i = indexInTile();
    return ivec2((i & 1u) | (i >> 1 & 6u), (i >> 1 & 1u) | (i >> 3 & 6u));
}

vec2 placeInQuad() {
    uint i = indexInTile();
    return vec2(i & 1u, i >> 1 & 1u);
}

// 1 for the pixel's own place of four, 0 for the others.
vec4 partOfQuad() {
    return vec4(equal(uvec4(0u, 1u, 2u, 3u), uvec4(indexInTile() & 3u)));
}

// In which array all of the tile have told theirs.
uint tellQuad(vec4 own, inout uint turn) {
    uint told = turn;
    turn ^= 1u;
    ofQuads[told][indexInTile()] = own;
    if (quadsInStep) {
        subgroupMemoryBarrierShared();
        subgroupBarrier();
    } else {
        barrier();
    }
    return told;
}

vec4 meanOfQuad(vec4 own, inout uint turn) {
    uint told = tellQuad(own, turn), first = indexInTile() & ~3u;
    vec4 upper = ofQuads[told][first] + ofQuads[told][first + 1u];
    return 0.25 * (upper + (ofQuads[told][first + 2u] + ofQuads[told][first + 3u]));
}

// From this pixel to the next, whichever way is more.
vec2 changeInQuad(vec2 own, inout uint turn) {
    uint told = tellQuad(vec4(own, 0.0, 0.0), turn), i = indexInTile();
    return max(abs(ofQuads[told][i ^ 1u].xy - own), abs(ofQuads[told][i ^ 2u].xy - own));
}

shared uint bitsOfTile;

// All bits of any pixel of the tile, whatever the quads are in step with. To be asked once.
uint bitsAround(uint own) {
    if (gl_LocalInvocationIndex == 0u) bitsOfTile = 0u;
    barrier();
    atomicOr(bitsOfTile, own);
    barrier();
    return bitsOfTile;
}

#endif
