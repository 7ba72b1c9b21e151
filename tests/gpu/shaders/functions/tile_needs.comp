// Which tiles tile_needs.glsl says may do without: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

// In place of a body's, and of the lists.
#include "pinhole.glsl"
#define FOUND_TILES_GLSL
const bool hasReflection = true, hasRefraction = true;
const int reflectionColorBinding = 2, reflectionInfoBinding = 3;
#include "found_tiles_block.h"
#define CONSTANT(number, kind, name, usual) const kind name = kind(1);
struct Water {
    float reflectionScale;
};
Water water;
FoundTilesHeader header;
float deviation;
float slopeDeviation() {
    return deviation;
}
ivec2 tileSize() {
    return ivec2(8);
}
ivec2 hit;   // the one texel that mirrors something
#define textureQueryLevels(map) 1
#define textureSize(map, mip) (regionSize() / int(water.reflectionScale))
#define texelFetch(map, at, mip) vec4((at) == hit ? 1.0 : infoUnknown)
#include "tile_needs.glsl"

layout(local_size_x = 64) in;

struct Ask {
    uvec4 box;   // as the header holds it
    vec4 tile;   // its first pixel, slopes' deviation
    ivec4 hit;   // a texel, and pixels to one
};
layout(set = 0, binding = 0, std430) readonly buffer Given {
    Ask asked[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 needs[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= asked.length()) return;
    deviation = asked[i].tile.z;
    header.mirrored = header.behind = asked[i].box;
    hit = asked[i].hit.xy;
    water.reflectionScale = float(asked[i].hit.z);
    ivec2 first = ivec2(asked[i].tile.xy);
    needs[i] = vec4(mayMirror(first), maySeeBed(first), mirrorsScene(first), 0.0);
}
