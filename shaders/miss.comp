// SSPR where no key is near: sky, or nothing known. Colour is left as it was cleared. An invocation takes a column of a
// tile, so that what is the same for all pixels is made ready once.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(local_size_x = tileEdge * emptyTilesPerGroup, local_size_y = 1) in;

layout(set = 0, binding = 1, std430) readonly buffer Tiles {
    TileHeader header;
    uint tiles[];
};
layout(set = 0, binding = 2) uniform sampler2D sceneDepth;
layout(set = 0, binding = 3, r16f) uniform writeonly image2D reflectionInfo;

#include "miss.glsl"

void main() {
    loadMirror();
    uint group = gl_WorkGroupID.y * groupsPerRow + gl_WorkGroupID.x;
    uint n = group * emptyTilesPerGroup + (gl_LocalInvocationID.x >> tileShift);
    if (n >= header.emptyGroups.w) return;
    ivec2 tile = unpackedTile(tiles[uint(2 * tilesAcross() * tilesDown()) - 1u - n]);
    ivec2 pixel = tile * tileEdge + ivec2(gl_LocalInvocationID.x & (tileEdge - 1), 0);
    ivec2 size = imageSize();
    if (pixel.x >= size.x) return;
    int rows = min(tileEdge, size.y - pixel.y);
    FarEnd end = farEndOf(middleOf(pixel));
    FarEnd perRow = farEndPerRow(float(1 << pixelShift));
    for (int row = 0; row < rows; ++row) {
        imageStore(reflectionInfo, pixel, vec4(infoOfFarEnd(end), 0.0, 0.0, 0.0));
        end.point += perRow.point;
        end.ahead += perRow.ahead;
        ++pixel.y;
    }
}
