// SSPR where no key is near: sky, or nothing known. Colour is left as it was cleared.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(set = 0, binding = 1, std430) readonly buffer Tiles {
    TileHeader header;
    uint tiles[];
};
layout(set = 0, binding = 2) uniform sampler2D sceneDepth;
layout(set = 0, binding = 3, r16f) uniform writeonly image2D reflectionInfo;

#include "miss.glsl"
#include "tile_list.glsl"

void main() {
    ivec2 pixel = pixelWithoutKeys();
    if (pixel == noPixel) return;
    vec2 q = middleOf(pixel);
    imageStore(reflectionInfo, pixel, vec4(planeAhead(q) ? infoOfMiss(q) : infoUnknown, 0.0, 0.0, 0.0));
}
