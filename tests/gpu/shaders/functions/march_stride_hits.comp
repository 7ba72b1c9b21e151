// Where march_strides.glsl finds that a receding ray goes behind walls: shader_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mirror_block.h"

// In place of the march's own, whose file stays out: of a row of pixels with sky to both sides of a wall, which is thin.
#define MARCH_GLSL
const float pixels = 200.0;
const float first = 0.9, last = 0.1;   // depths of the ray
const float thickness = 0.01;
struct Settings {
    float jitter;
    int steps;
};
const Settings settings = Settings(0.0, 8);
struct Scene {
    float wallFrom, wallTo;   // columns
    float wallDepth;
};
struct Track {
    vec3 first;
    vec3 along;
    float halfPixel;
    Scene scene;
};
struct Seen {
    float depth;
    bool counts;
};
struct Cover {
    float depth;
    float from;
};
struct Progress {
    float reached;
    bool inFront;
    bool hidden;
    Cover cover;
    int taps;
};
struct Crossing {
    bool found;
    float share;
    vec3 shown;
    float begins;
    float ends;
    bool close;
    bool thin;
    float coveredFrom;
};
const float inSight = 2.0;
const Cover noCover = Cover(-2.0, 0.0);
const Crossing noCrossing = Crossing(false, 0.0, vec3(0.0), 0.0, 0.0, false, false, inSight);

vec3 trackPoint(Track track, float share) {
    return track.first + share * track.along;
}
ivec2 pixelAt(Scene scene, vec2 point) {
    return ivec2(floor(point));
}
Seen seenAt(Scene scene, ivec2 pixel) {
    bool wall = float(pixel.x) >= scene.wallFrom && float(pixel.x) < scene.wallTo;
    return Seen(wall ? scene.wallDepth : 0.0, wall);
}
bool within(Track track, float share, float ray, float seen) {
    return seen - ray <= thickness;
}
bool coverEnds(Track track, float share, float ray, Seen seen, bool isBehind, inout Cover cover) {
    return false;
}
#include "march_strides.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    vec4 walls[];   // first column, and one past the last; depth
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 hits[];   // whether one is found, and the column
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= walls.length()) return;
    MirrorBlock mirror;
    Track track = Track(vec3(0.0, 3.5, first), vec3(pixels, 0.0, last - first), 0.5 / pixels, Scene(walls[i].x, walls[i].y, walls[i].z));
    Progress at = atStart(track, 0.0);
    Crossing crossing = nextCrossing(mirror, track, at);
    hits[i] = vec4(crossing.found ? 1.0 : 0.0, crossing.share * pixels, 0.0, 0.0);
}
