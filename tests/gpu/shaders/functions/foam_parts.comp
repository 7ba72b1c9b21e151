// What foam_cover.glsl and surf.glsl make white: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "hash.glsl"

// In place of a body's, of its maps, and of the light that foam is in.
#define BODY_GLSL
#define FOAM_GATE_GLSL
#define SUN_GLINT_GLSL
#define SURFACE_FOG_GLSL
#define SURFACE_POINT_GLSL
#define WATER_LIGHT_GLSL
#define WAVE_DISPLACEMENT_GLSL
#include "footprint.glsl"
#include "slopes.glsl"
#include "optics.glsl"
const bool hasShore = false, hasFoam = true;
const int foamCascades = 1;
struct Water {
    vec4 breaking, compression, windrows, foamDrift[4], shoreForm;
    vec2 foamStreak, foamPlace;
    float foamStep, foamAlbedo;
};
const vec4 none[4] = vec4[](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
const float fades = 3.0;   // e-folds of breakers' foam in a period
const Water water = Water(vec4(0.0), vec4(0.0), vec4(0.0), none, vec4(0.0, 0.0, 0.0, fades), vec2(0.0), vec2(0.0), 0.0, 0.0);
#include "surf.glsl"
struct ShoreSeen {
    vec4 kept;
    float thick, wet, rushes, swash;
    vec2 advected;
    Breakers breakers;
};
struct SurfacePoint {
    vec2 calm;
    Footprint footprint;
    ShoreSeen shore;
    vec2 slope;
    vec3 covariance;
    vec2 compressed;
    float sunSeen;
    vec4 air;
};
struct WavesAhead {
    float unseen;
};
float sunGlint(const SurfacePoint s, vec3 toEye, bool sparkles) {
    return 0.0;
}
float sunClear(vec3 toSun, vec2 slope, WavesAhead ahead) {
    return 1.0;
}
vec3 sunDirection(const SurfacePoint s) {
    return vec3(0.0, 1.0, 0.0);
}
vec3 sunLight(float share) {
    return vec3(share);
}
vec3 sunEntering(vec3 toSun) {
    return vec3(0.0);
}
vec3 skyEntering() {
    return vec3(0.0);
}
vec3 extinction() {
    return vec3(0.0);
}
vec3 lightBy(float sun, float sky) {
    return vec3(sun + sky);
}
vec3 throughAir(vec3 light, vec4 air) {
    return light;
}
vec2 warped(vec2 calm) {
    return calm;
}
float foamGate(vec2 place, float width) {
    return 1.0;
}
float texelsInAMetre(int cascade) {
    return 1.0;
}
vec3 inTile(vec2 place, int cascade) {
    return vec3(place, 0.0);
}
vec2 partOf(Footprint pixel) {
    return pixel.longer;
}
int partsOfPixel() {
    return 1;
}
float partsAside(int i) {
    return 0.0;
}
float bare;   // share of the surface
vec4 foamHistoryTexel(vec3 at, float mip) {
    return vec4(bare, bare, 1.0, 1.0);
}
// Even in 0..1, of a place's own, and as blurred as mips are.
vec4 foamPatternTexel(vec2 at, float mip) {
    uint bits = scrambled(floatBitsToUint(at.x) ^ scrambled(floatBitsToUint(at.y)));
    return 0.5 + (vec4(shareOf(bits), shareOf(scrambled(bits + 1u)), 0.5, 0.5) - 0.5) * 30.0 / (29.15 + exp2(mip));
}
#define textureLod(map, at, mip) map##Texel(at, mip)
#include "foam_cover.glsl"

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

// Of a place of the pattern, so blurred.
float whiteOf(vec2 place, float patternWidth) {
    SurfacePoint s;
    s.calm = s.compressed = vec2(0.0);
    FoamPart part = FoamPart(place, place, place.yx, 0.0);
    return foamAt(s, vec2(0.0), part, 0.01, vec2(patternWidth), Whitecaps(1.0, 0.0)).mask;
}

float foamOfShore(vec4 a) {
    ShoreSeen shore;
    shore.thick = a.x;
    shore.wet = a.y;
    shore.rushes = a.z;
    shore.swash = a.w;
    shore.breakers = Breakers(0.0, 0.0, 1.0);
    return shoreFoam(shore, 0.0);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= asked.length()) return;
    Ask ask = asked[i];
    int what = int(ask.b.w);
    vec4 answer = vec4(0.0);
    bare = 1.0 - ask.b.x;
    if (what == 0) answer.x = whiteOf(ask.a.xy, ask.a.z);
    if (what == 1) answer.x = foamPatternAt(FoamPart(ask.a.xy, ask.a.zw, vec2(0.0), ask.b.x), 1.0, 0.0).x;
    if (what == 2) answer.x = foamOfShore(ask.a);
    if (what == 3) answer.x = surfFoam(Breakers(ask.a.x, ask.a.y, ask.a.z), ask.a.w);
    told[i] = answer;
}
