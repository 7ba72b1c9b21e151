// Draws what the library makes of its inputs, so that a wrong matrix is seen at once: reflection/debug/overlay.h.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "overlay_block.h"
#include "reflection_info.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = settingsBinding, std140) uniform Overlay {
    OverlayBlock settings;
};
layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = reflectionColorBinding) uniform sampler2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding) uniform sampler2D reflectionInfo;
layout(set = 0, binding = overlayTargetBinding, rgba16f) uniform writeonly image2D target;

const int kindDepth = 0;
const int kindPlane = 1;
const int kindClasses = 2;
const int kindConfidence = 3;

// As seaglass/reflection.h tells them.
const vec3 noDepth = vec3(1.0, 0.0, 1.0);
const vec3 farPlane = vec3(0.5, 0.75, 1.0);
const vec3 noMirror = vec3(0.06, 0.07, 0.1);
const vec3 mirrorSeen = vec3(0.1, 0.35, 0.8);
const vec3 low = vec3(0.2, 0.55, 0.25);
const vec3 high = vec3(0.95, 0.95, 0.85);
const vec3 hit = vec3(0.0, 1.0, 0.0);
const vec3 sky = vec3(0.0, 0.0, 1.0);
const vec3 unknown = vec3(1.0, 0.0, 0.0);
const vec3 noConfidence = vec3(0.6, 0.0, 0.1);
const vec3 fullConfidence = vec3(0.95, 0.95, 0.9);
// From a tenth of a metre to a kilometre, a decade each.
const vec3 decades[5] = vec3[](vec3(1.0, 1.0, 1.0), vec3(1.0, 0.85, 0.2), vec3(0.1, 0.65, 0.6), vec3(0.35, 0.15, 0.6),
                               vec3(0.08, 0.05, 0.2));
const float contoursToHigh = 10.0;
const float oddBand = 0.8;

// Bands end at 1, 2 and 5 metres, and at their powers of ten.
float bandShade(float metres) {
    float decade = floor(log2(max(metres, 1e-6)) * 0.30103);
    float share = metres * pow(10.0, -decade);
    int band = int(decade) * 3 + (share >= 5.0 ? 2 : share >= 2.0 ? 1 : 0);
    return (band & 1) != 0 ? oddBand : 1.0;
}

vec3 distanceColor(float metres) {
    metres = clamp(metres, 1e-6, 1e9);
    float at = clamp(log2(metres) * 0.30103 + 1.0, 0.0, 3.999);
    return mix(decades[int(at)], decades[int(at) + 1], fract(at)) * bandShade(metres);
}

vec4 seenAt(const MirrorBlock mirror, ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), regionSize(mirror) - 1);
    return vec4(vec2(inside) + 0.5, texelFetch(sceneDepth, sceneTexel(mirror, inside), 0).r, 1.0);
}

bool isDepth(float depth) {
    return depth >= 0.0 && depth <= 1.0;
}

// Whether the plane comes before what was drawn.
bool mirrorBefore(const MirrorBlock mirror, vec4 seen) {
    if (isFar(mirror, seen.z)) return heightAtInfinity(mirror, seen.xy) < 0.0;
    return onOrBelowPlane(mirror, seen.xyz);
}

vec3 depthColor(const MirrorBlock mirror, vec4 seen) {
    float weight = weightOf(mirror, seen);
    if (isFar(mirror, seen.z)) return farPlane;
    return weight > 0.0 ? distanceColor(dot(settings.forwardRow, seen) / weight) : noDepth;
}

float metresToPlane(const MirrorBlock mirror, vec2 pixel) {
    SightLine sight = sightThrough(mirror, pixel);
    return dot(sight.onPlane, sight.direction);
}

bool contourBetween(const MirrorBlock mirror, float height, vec4 other) {
    if (isFar(mirror, other.z) || mirrorBefore(mirror, other)) return false;
    return floor(height / settings.contourSpacing) != floor(heightOf(mirror, other) / settings.contourSpacing);
}

vec3 planeColor(const MirrorBlock mirror, ivec2 pixel, vec4 seen) {
    if (mirrorBefore(mirror, seen)) return mirrorSeen * bandShade(metresToPlane(mirror, seen.xy));
    if (isFar(mirror, seen.z)) return farPlane;
    float height = heightOf(mirror, seen);
    bool line = contourBetween(mirror, height, seenAt(mirror, pixel + ivec2(1, 0))) ||
                contourBetween(mirror, height, seenAt(mirror, pixel + ivec2(0, 1)));
    return line ? vec3(0.0) : mix(low, high, clamp(height / (settings.contourSpacing * contoursToHigh), 0.0, 1.0));
}

vec3 classColor(float info) {
    if (infoIsHit(info)) return hit;
    return infoIsSky(info) ? sky : unknown;
}

vec3 hitDistanceColor(float info) {
    if (infoIsHit(info)) return distanceColor(info);
    return infoIsSky(info) ? farPlane : unknown;
}

vec3 knownColor(const MirrorBlock mirror, ivec2 pixel, vec4 seen) {
    if (!mirrorBefore(mirror, seen)) return noMirror;
    ivec2 texel = reflectionPixel(mirror, pixel);
    float info = texelFetch(reflectionInfo, texel, 0).r;
    if (settings.kind == kindClasses) return classColor(info);
    if (settings.kind == kindConfidence) return mix(noConfidence, fullConfidence, texelFetch(reflectionColor, texel, 0).a);
    return hitDistanceColor(info);
}

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (beyondRegion(mirror, pixel)) return;
    vec4 seen = seenAt(mirror, pixel);
    vec3 color = noDepth;
    if (isDepth(seen.z)) {
        if (settings.kind == kindDepth) color = depthColor(mirror, seen);
        else if (settings.kind == kindPlane) color = planeColor(mirror, pixel, seen);
        else color = knownColor(mirror, pixel, seen);
    }
    imageStore(target, sceneTexel(mirror, pixel), vec4(color, 1.0));
}
