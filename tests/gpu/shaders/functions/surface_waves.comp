// How surface_point.glsl takes waves together, and wave_warp.glsl draws them out of shape: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// In place of a body's, of its maps, and of what else a surface has.
#define BODY_GLSL
#define GUSTS_GLSL
#define SURFACE_GLSL
#define TILE_QUAD_GLSL
const bool hasWaves = true, isWarped = true, hasShore = true, hasFoam = false, hasGusts = false, onGlobe = false;
const int cascades = 1, slopeSamples = 4;
struct Water {
    vec4 warpAlong[3], warpFrom[3], cascade[1], compression;
    vec4 breakingCounts;
    float maxMip;
};
const vec4 warpAlong[3] = vec4[](vec4(2e-3, 1e-3, -1.3e-3, 2.2e-3), vec4(7e-3, -3e-3, 2e-3, 6e-3), vec4(0.0, 0.02, 0.03, 0.0));
const vec4 warpFrom[3] = vec4[](vec4(0.1, 0.2, 90.0, 0.0), vec4(-0.3, 0.4, 30.0, 0.0), vec4(0.25, -0.1, 8.0, 0.0));
const vec4 cascade[1] = vec4[](vec4(0.0, 0.0, 1.0, 1.0));
const Water water = Water(warpAlong, warpFrom, cascade, vec4(0.0), vec4(0.0), 8.0);
struct Breakers {
    float broken;
};
struct ShoreWave {
    vec4 kept;
    float depth;
    vec2 bedSlope;
    float height;
    vec2 move;
    float swash, wetTo;
    vec2 advected;
    float rushes;
};
Breakers breakersOf(ShoreWave w) {
    return Breakers(0.0);
}
vec3 sunAtEye() {
    return vec3(0.0, 1.0, 0.0);
}
vec3 unresolvedSlopes() {
    return vec3(0.002, 0.001, 0.0005);
}
vec3 roughenedByGusts(vec3 covariance, vec2 calm, float width) {
    return covariance;
}
vec2 changeInQuad(vec2 own, inout uint turn) {
    return vec2(0.0);
}
// Along a tile they change in step with the place.
vec4 waveDerivativesTexel(vec3 at) {
    return 1e-3 * vec4(at.xy, -at.y, at.x);
}
vec4 waveMomentsTexel(vec3 at) {
    return vec4(0.04, 0.03, 0.01, 0.0) + 1e-3 * vec4(at.x, at.y, 0.0, at.x);
}
#define textureLod(map, at, mip) map##Texel(at)
#define textureGrad(map, at, along, across) map##Texel(at)
#include "wave_warp.glsl"
#include "surface_point.glsl"

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

vec3 covarianceBy(float kept) {
    SurfacePoint s;
    s.calm = vec2(0.0);
    s.footprint = Footprint(vec2(0.1, 0.0), vec2(0.0, 0.1), 0.1);
    s.shore.kept = vec4(kept);
    s.shore.thick = 1.0;
    uint turn = 0u;
    findSlopes(s, WaveGradient(vec2(0.0), vec2(0.0), vec2(0.0)), vec3(0.0), turn);
    return s.covariance;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= asked.length()) return;
    Ask ask = asked[i];
    int what = int(ask.b.w);
    vec4 answer = vec4(0.0), moments;
    if (what == 0) answer = vec4(warped(ask.a.xy), waveGradient(vec4(ask.b.xy, 0.0, 0.0), 0.0, ask.a.xy).height);
    if (what == 1) sampleWaves(vec3(ask.a.xy, 0.0), 0, Footprint(ask.a.zw, vec2(0.0), length(ask.a.zw)), answer, moments);
    if (what == 2) answer.xyz = covarianceBy(ask.a.x);
    told[i] = answer;
}
