// Sorts the tiles that are looked up into two lists: those with keys in or around them or, with OVERHANGS, with something
// that hangs over them, and the rest. The order within a list is any; what is computed of a tile does not depend on it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"

layout(local_size_x = 64, local_size_y = 1) in;

#include "list_tile.glsl"

#ifdef OVERHANGS
#include "keys.glsl"
#include "screen_ray.glsl"
#include "overhang_taps.glsl"
#include "scene_depth.glsl"
#include "hidden_way.glsl"
#include "hits.glsl"
#include "overhangs.glsl"

// What hangs over a mirror may reach farther than any keys are near: here and there in a tile.
bool hangsOver(const MirrorBlock mirror, ivec2 tile) {
    float pixels = float(tilePixels(mirror));
    for (int i = 0; i < 4; ++i) {
        vec2 q = (vec2(tile) + vec2(0.25) + 0.5 * vec2(i & 1, i >> 1)) * pixels;
        if (underOverhang(mirror, q, rayOf(mirror, q), noHit).valid) return true;
    }
    return false;
}
#else
bool hangsOver(const MirrorBlock mirror, ivec2 tile) {
    return false;
}
#endif

void main() {
    MirrorBlock mirror = storedMirror;
    int count = tilesAcross(mirror) * tilesDown(mirror);
    int index = int(gl_GlobalInvocationID.x);
    if (index == 0) beginLists();
    if (index >= count) return;
    ivec2 tile = ivec2(index % tilesAcross(mirror), index / tilesAcross(mirror));
    if (!lookedUp(mirror, tile, tiles[index])) return;
    if (keysNear(mirror, tile) || hangsOver(mirror, tile))
        listTile(mirror, tile);
    else
        listTileOfColumns(mirror, tile);
}
