// Where hidden_way.glsl says that rays of one depth went behind a wall of pixels: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mirror_block.h"

// In place of the mirror's and the march's, whose files stay out: of a picture in which a wall is nearer than the ray.
#define SCENE_DEPTH_GLSL
#define SCREEN_RAY_GLSL
#define OVERHANG_TAPS_GLSL
const int firstTap = 8;
const int mostOverhangSamples = 4;
struct ScreenRay {
    float depth;
    ivec2 wall;   // its first column, and one past its last
};
ivec2 wallOfRay;
ivec2 regionPixel(const MirrorBlock mirror, vec2 point) {
    return ivec2(floor(point));
}
vec2 regionSize(const MirrorBlock mirror) {
    return vec2(256.0);
}
float depthAt(const MirrorBlock mirror, ivec2 pixel) {
    return pixel.x >= wallOfRay.x && pixel.x < wallOfRay.y ? 0.75 : 0.25;
}
float fromInfinity(const MirrorBlock mirror, float depth) {
    return depth;
}
float signedDepth(const MirrorBlock mirror, float depth) {
    return depth;
}
float rayDepthAt(ScreenRay ray, vec2 point) {
    return ray.depth;
}
float farthest(vec2 way) {
    return max(abs(way.x), abs(way.y));
}
#include "hidden_way.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    vec4 ways[];   // the wall's columns, where the ray is hidden, where it comes from
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 entries[];   // the columns between which it went in, and the last hidden point's
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= ways.length()) return;
    MirrorBlock mirror;
    wallOfRay = ivec2(ways[i].xy);
    ScreenRay ray = ScreenRay(0.5, wallOfRay);
    Entry entry = entryBefore(mirror, ray, vec2(ways[i].w, 3.5), vec2(ways[i].z, 3.5), backPixels);
    entries[i] = vec4(entry.between.one.x, entry.between.other.x, entry.hidden.x, entry.depth);
}
