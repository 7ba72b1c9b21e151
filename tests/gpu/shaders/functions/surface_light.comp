// What surface_mirror.glsl, sun_glint.glsl and subsurface_scattering.glsl make of slopes: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// In place of a body's and of its maps, of one wave that stands ahead and of a black sky.
#define BODY_GLSL
#define FOAM_COVER_GLSL
#define GLITTER_GLSL
#define IN_WORLD_GLSL
#define REFLECTION_LOOKUP_GLSL
#define REFRACTION_GLSL
#define SKY_SEEN_GLSL
#define SURFACE_FOG_GLSL
#define SURFACE_GLSL
#define SURFACE_POINT_GLSL
#define WATER_LIGHT_GLSL
#define WAVE_DISPLACEMENT_GLSL
#include "slopes.glsl"
const bool hasWaves = true, hasReflection = false, hasRefraction = false, hasShore = false, hasGlitter = false, bySchlick = false;
const bool skyHasColors = true;
const int waveShadowSteps = 16, reflectionSamples = 2;
struct ShoreSeen {
    vec4 kept;
};
struct SurfacePoint {
    vec2 pixel;
    bool quadIsAlike;
    vec2 calm;
    float pixelLength;
    vec3 position, overPlane;
    float height;
    ShoreSeen shore;
    vec2 slope;
    vec3 covariance;
    float slopeStep, bounded, sunSeen;
    vec4 air;
};
vec3 toSun;
float deviationOfAll;
float crestAhead;   // how high it is, ten metres along u [m]
vec3 sunDirection(const SurfacePoint s) {
    return toSun;
}
vec3 sunInWater() {
    return toSun;
}
float slopeDeviation() {
    return deviationOfAll;
}
float heightDeviation() {
    return 1.0;
}
vec4 keptAt(const SurfacePoint s) {
    return vec4(1.0);
}
vec3 fromLevel(const SurfacePoint s, vec3 direction) {
    return direction;
}
const int waveDisplacement = 0;
vec3 waveDisplacementAt(int map, vec2 calm, float width, vec4 kept) {
    float away = (calm.x - 10.0) / 3.0;
    return vec3(0.0, crestAhead * exp(-away * away), 0.0);
}
vec3 surfaceDisplacement(int map, vec2 calm, float width) {
    return waveDisplacementAt(map, calm, width, vec4(1.0));
}
float cubeMips() {
    return 1.0;
}
vec3 cubeAt(vec3 along, float mip) {
    return vec3(0.0);
}
vec3 skyOfColors(vec3 along, float spread) {
    return vec3(0.0);
}
vec3 inWorld(vec3 along) {
    return along;
}
vec3 foggedSky(vec3 sky, vec3 from, vec3 along) {
    return sky;
}
vec3 throughAir(vec3 light, vec4 air) {
    return light;
}
vec3 sceneThroughAir(vec3 light, vec3 share, vec4 air) {
    return light;
}
vec4 reflectionAlong(const SurfacePoint s, vec3 along, float spread, inout float hit) {
    return vec4(0.0);
}
vec4 mirroredOverSand(const SurfacePoint s, vec3 along) {
    return vec4(0.0);
}
float deepEnough(const ShoreSeen shore) {
    return 1.0;
}
float blurTexels(vec3 from, float spread, float hit) {
    return 0.0;
}
float hitAt(vec2 pixel) {
    return 0.0;
}
vec4 partOfQuad() {
    return vec4(0.25);
}
vec4 meanOfQuad(vec4 own, inout uint turn) {
    return own;
}
SurfacePoint patchOf(const SurfacePoint s) {
    return s;
}
vec3 sunLight(float share) {
    return vec3(share);
}
vec3 extinction() {
    return vec3(0.1);
}
float scatteredByParticles() {
    return 0.1;
}
int pointsLit() {
    return 1;
}
#include "optics.glsl"
#include "sun_glint.glsl"
#include "subsurface_scattering.glsl"

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

SurfacePoint levelPoint(vec3 covariance) {
    return SurfacePoint(vec2(0.0), true, vec2(0.0), 0.01, vec3(0.0), vec3(0.0), 0.0, ShoreSeen(vec4(1.0)), vec2(0.0), covariance, 0.0, 0.0, 1.0, vec4(1.0));
}

// Moments of the slopes that are looked at, for the slope at which facets are edge on [deviations].
vec4 momentsSeen(float edgeOn) {
    SlopeSpread seen = slopeSpread(VisibleSlopes(vec2(1.0, 0.0), 1.0, edgeOn));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < slopesSeen; ++i) {
        float x = slopeSeen(i, seen);
        sum += shareOfSlope(i) * vec3(x, x * x, x * x * x);
    }
    return vec4(sum, seen.skew);
}

// Of rays that rise so steeply the share that other waves mirror.
float keptOfMet(vec3 ray) {
    Reflection sum = Reflection(vec3(0.0), 0.0, 0.0);
    return skyOfMet(vec4(ray, 1.0), vec4(0.0), 0.0, sum).weight;
}

// Light through a crest without a slope, straight on to the eye.
float throughCrest() {
    SurfacePoint s = levelPoint(vec3(1e-6, 1e-6, 0.0));
    CrestSide side = CrestSide(horizontal(toSun), 0.0, 0.5);
    return sunScattered(s, side, s.calm, -refract(-toSun, vec3(0.0, 1.0, 0.0), 1.0 / waterIndex)).x;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= asked.length()) return;
    Ask ask = asked[i];
    int what = int(ask.b.w);
    vec4 answer = vec4(0.0);
    deviationOfAll = ask.b.x;
    crestAhead = ask.b.y;
    toSun = ask.a.xyz;
    if (what == 0) answer = momentsSeen(ask.a.x);
    if (what == 1) answer.x = deviationAcross(levelPoint(ask.a.xyz), ask.b.xy);
    if (what == 2) answer.x = keptOfMet(ask.a.xyz);
    if (what == 3) answer.x = glintOfWaves(levelPoint(vec3(ask.b.xx * ask.b.xx, 0.0)), vec3(ask.b.y, ask.b.z, 0.0), false);
    if (what == 4) answer.x = throughCrest();
    told[i] = answer;
}
