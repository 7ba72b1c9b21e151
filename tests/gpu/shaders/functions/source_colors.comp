// What source_color.glsl blends: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mirror_block.h"
#include "texel_at.glsl"

// In place of the mirror's and of the scene: a wall of radiance 1, so far away that its depth is hardly told from the far plane's, right
// of which the far plane shows radiance 0.
#define DEPTH_QUADS_GLSL
#define ENCODING_GLSL
const int sceneColorBinding = 2, columns = 8;
struct Scene {
    float wall;         // its depth; the far plane has 0
    bool underHorizon;
};
Scene scene;
vec3 linearOf(vec3 held, bool encoded) {
    return held;
}
ivec2 regionPixel(const MirrorBlock mirror, vec2 point) {
    return texelAt(point, ivec2(2 * columns - 1));
}
ivec2 sceneTexel(const MirrorBlock mirror, ivec2 pixel) {
    return pixel;
}
vec2 perDepthTexel() {
    return vec2(1.0);
}
vec4 depthsAround(const MirrorBlock mirror, ivec2 corner, vec2 perTexel) {
    vec2 row = vec2(corner.x - 1 < columns ? scene.wall : 0.0, corner.x < columns ? scene.wall : 0.0);
    return row.xyyx;
}
vec4 allFromInfinity(const MirrorBlock mirror, vec4 depths) {
    return depths;
}
float depthFromInfinity(const MirrorBlock mirror, float off) {
    return off;
}
float signedDepth(const MirrorBlock mirror, float depth) {
    return depth;
}
vec4 signedDepths(const MirrorBlock mirror, vec4 depths) {
    return depths;
}
bool isFar(const MirrorBlock mirror, float depth) {
    return depth <= 0.0;
}
bool wellBelowPlane(const MirrorBlock mirror, vec3 point) {
    return scene.underHorizon;
}
#define texelFetch(map, at, mip) vec4(at.x < columns ? 1.0 : 0.1)
#include "source_color.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    vec4 points[];   // column, the wall's depth, a step of depths, whether it is under the horizon
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 colors[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= points.length()) return;
    vec4 p = points[i];
    scene = Scene(p.y, p.w > 0.0);
    MirrorBlock mirror;
    mirror.depthStep = p.z;
    colors[i] = vec4(sourceColor(mirror, vec2(p.x, 4.3), p.y), 0.0);
}
