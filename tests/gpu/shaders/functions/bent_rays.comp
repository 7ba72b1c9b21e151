// How refraction.glsl bends rays, and what it says that they meet: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// In place of a body's, of its maps, and of the scene: a level bed, and to the left of a column a wall that stands in the water.
#include "pinhole.glsl"
#define ENCODING_GLSL
#define LIT_BELOW_GLSL
#define NEAR_PLANE_GLSL
#define SCENE_BEHIND_GLSL
#define SURFACE_FOG_GLSL
#define SURFACE_FRESNEL_GLSL
#define SURFACE_POINT_GLSL
#define WATER_LIGHT_GLSL
#include "optics.glsl"
#include "slopes.glsl"
const bool hasWaves = true, hasShore = false, hasRefraction = true, manySamples = false, sceneIsEncoded = false;
const int refractionSamples = 6, bedDownscale = 0;
struct Water {
    mat4 bedFromRelative, relativeFromBed;
    ivec4 bedSize;
    float refractionDistortion;
};
const Water water = Water(mat4(1.0), mat4(1.0), ivec4(1), 1.0);
struct ShoreSeen {
    float depth;
    vec2 bedSlope;
};
struct SurfacePoint {
    vec2 pixel;
    vec3 position;
    float height;
    ShoreSeen shore;
    vec2 slope;
    vec3 covariance;
    vec4 air;
};
layout(set = 0, binding = 2) uniform sampler2D bedColor, bedDepth;   // not looked at
struct Behind {
    vec2 pixel;
    vec3 seen;
    bool nothing;
};
float bedIsDeep, wallIsDeep, wallEnds;   // under the water [m], and a column
Behind behindAt(vec2 pixel) {
    vec3 sight = pointAt(pixel, 1.0);
    float deep = eyeHeight + (pixel.x < wallEnds ? wallIsDeep : bedIsDeep);
    return Behind(floor(pixel), sight * (deep / -sight.y), false);
}
Behind shownAt(vec2 pixel, float depth, vec4 q) {
    return behindAt(pixel);
}
vec4 linearTexel(vec4 held) {
    return held;
}
vec4 colorOf(Behind b) {
    return vec4(1.0);
}
float untilBorder(vec4 a, vec4 b, vec2 size) {
    return 1e6;
}
bool isFarPlane(float depth) {
    return false;
}
float alongParallels(vec3 at) {
    return 0.0;
}
float heightOverCalm(vec3 at) {
    return at.y - calmLevel();
}
vec3 sunDirection(const SurfacePoint s) {
    return vec3(0.0, 1.0, 0.0);
}
vec3 extinction() {
    return vec3(0.1);
}
vec3 endlessGlow(vec3 toSun) {
    return vec3(0.0);
}
vec3 waterGlow(vec3 toSun, vec3 path) {
    return vec3(0.0);
}
vec3 throughAir(vec3 light, vec4 air) {
    return light;
}
vec3 sceneThroughAir(vec3 light, vec3 share, vec4 air) {
    return light;
}
vec3 litBelow(vec3 toSun, vec3 inAir, float depth, float gathered) {
    return inAir;
}
float gatheredIn(vec4 color) {
    return 1.0;
}
vec4 partOfQuad() {
    return vec4(0.25);
}
uint indexInTile() {
    return 0u;
}
#include "refraction.glsl"

layout(local_size_x = 64) in;

struct Ask {
    vec4 a, b;   // the last of `b` says what is asked
};
layout(set = 0, binding = 0, std430) readonly buffer Given {
    Ask asked[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 told[];
};

// Whether a ray from a place six metres ahead meets something between two depths, and at which.
vec4 metBetween(vec3 perDepth, float before, float depth) {
    SurfacePoint s;
    s.position = vec3(0.0, -eyeHeight, -6.0);
    vec4 from = homogeneousPixel(s.position), by = homogeneousPerMetre(perDepth);
    Behind there = behindRay(from.xy / from.w, from + by * depth);
    bool met = meetsBetween(s, from, by, from.xy / from.w, before, there.seen.y, depth);
    return vec4(met, depth, 0.0, 0.0);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= asked.length()) return;
    Ask ask = asked[i];
    int what = int(ask.b.w);
    vec4 answer = vec4(0.0);
    if (what == 0) {
        SurfacePoint s;
        s.slope = ask.b.xy;
        s.covariance = vec3(ask.a.w * ask.a.w * vec2(1.0), 0.0);
        mat2 strays = straysPerDepth(s, ask.a.xyz);
        answer = vec4(strays[0], strays[1]);
    }
    bedIsDeep = ask.b.x;
    wallIsDeep = ask.b.y;
    wallEnds = ask.b.z;
    if (what == 1) answer = metBetween(ask.a.xyz, 0.0, ask.a.w);
    told[i] = answer;
}
