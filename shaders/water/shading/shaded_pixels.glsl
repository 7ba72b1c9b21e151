// Which pixel of a block is shaded.
#ifndef SHADED_PIXELS_GLSL
#define SHADED_PIXELS_GLSL

#include "shading_block.glsl"

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;

// 0 where nothing shows, and beyond the region.
float foundDepthAt(ivec2 at) {
    float depth = texelFetch(foundDepth, clamp(at, ivec2(0), regionSize() - 1), 0).r;
    return inRegion(vec2(at)) ? depth : 0.0;
}

bool showsSurface(ivec2 at) {
    return foundDepthAt(at) > 0.0;
}

// The usual one, and at the surface's edge the first that shows any.
ivec2 shadedPixel(ivec2 block) {
    ivec2 first = block * blockSize();
    ivec2 usual = first + ivec2(shiftOfRow(first.y), 0);
    if (allAreShaded() || showsSurface(usual)) return usual;
    for (int i = 0; i < blockWidth; ++i)
        if (showsSurface(first + ivec2(i, 0))) return first + ivec2(i, 0);
    return usual;
}

#endif
