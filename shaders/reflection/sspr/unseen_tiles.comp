// Leaves nothing in the tiles of a reflection that are not looked up; whoever makes it fills the others.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "listed_tiles.glsl"

// An invocation takes a column of a tile: a GPU takes longer to begin groups than to store what theirs would be.
layout(local_size_x = tileEdge * tilesPerColumnGroup, local_size_y = 1) in;

layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform writeonly image2D reflectionInfo;

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, tileEdge);
    ivec2 tile = pixel >> tileShift;
    ivec2 size = reflectionSize(mirror);
    if (pixel.x >= size.x || lookedUp(mirror, tile, tiles[tileAt(mirror, tile)])) return;
    for (int rows = min(tileEdge, size.y - pixel.y); rows > 0; --rows) {
        imageStore(reflectionColor, pixel, vec4(0.0));
        imageStore(reflectionInfo, pixel, vec4(infoUnknown, 0.0, 0.0, 0.0));
        ++pixel.y;
    }
}
