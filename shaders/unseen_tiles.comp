// Leaves nothing in the tiles of a reflection that are not looked up; whoever makes it fills the others.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(local_size_x = tileEdge, local_size_y = tileEdge) in;

layout(set = 0, binding = 1, std430) readonly buffer Tiles {
    TileHeader header;
    uint tiles[];
};
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = 3, r16f) uniform writeonly image2D reflectionInfo;

void main() {
    loadMirror();
    ivec2 tile = ivec2(gl_WorkGroupID.xy);
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize())) || lookedUp(tile, tiles[tileAt(tile)])) return;
    imageStore(reflectionColor, pixel, vec4(0.0));
    imageStore(reflectionInfo, pixel, vec4(infoUnknown, 0.0, 0.0, 0.0));
}
