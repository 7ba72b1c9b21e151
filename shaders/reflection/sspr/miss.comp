// SSPR where no key is near: sky, or nothing known. An invocation takes a column of a tile, so that what is the same for
// all pixels is made ready once.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(set = 0, binding = reflectionInfoBinding, r16f) uniform writeonly image2D reflectionInfo;
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;

#include "constant.glsl"
#include "miss_constants.h"

#include "scene_depth.glsl"
#include "miss.glsl"
#include "tile_columns.glsl"

void main() {
    MirrorBlock mirror = storedMirror;
    Column column = columnToVisit(mirror);
    if (column.rows == 0) return;
    ivec2 pixel = column.top;
    FarEnd end = farEndOf(mirror, middleOf(mirror, pixel));
    FarEnd perRow = farEndPerRow(mirror, pixelEdge(mirror));
    int row = 0;
    do {
        if (!colorIsCleared) imageStore(reflectionColor, pixel, vec4(0.0));
        imageStore(reflectionInfo, pixel, vec4(infoOfFarEnd(mirror, end), 0.0, 0.0, 0.0));
        end.point += perRow.point;
        end.ahead += perRow.ahead;
        ++pixel.y;
    } while (++row < column.rows);
}
