// Four depths of the image sceneDepth at once, which costs devices about as much as one.
#ifndef DEPTH_QUADS_GLSL
#define DEPTH_QUADS_GLSL

#include "scene_depth.glsl"

vec2 perDepthTexel() {
    return 1.0 / vec2(textureSize(sceneDepth, 0));
}

// Of the pixels to the lower left, lower right, upper right and upper left of a corner between pixels, y down. Some may lie
// outside of the region.
vec4 depthsAround(const MirrorBlock mirror, ivec2 corner, vec2 perTexel) {
    return textureGather(sceneDepth, vec2(sceneTexel(mirror, corner)) * perTexel);
}

#endif
