// What the image sceneDepth says of its pixels.
#ifndef SCENE_DEPTH_GLSL
#define SCENE_DEPTH_GLSL

#include "mirror.glsl"

layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;

float depthAt(const MirrorBlock mirror, ivec2 pixel) {
    return texelFetch(sceneDepth, sceneTexel(mirror, pixel), 0).r;
}

// Whether what shows at a pixel can be mirrored: neither the far plane nor deeper under the mirror than is told apart.
bool solid(const MirrorBlock mirror, ivec2 pixel, float depth) {
    return !isFar(mirror, depth) && !wellBelowPlane(mirror, vec3(vec2(pixel) + 0.5, depth));
}

#endif
