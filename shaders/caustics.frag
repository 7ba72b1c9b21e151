// What the waves make of the sunlight on the opaque scene below them, as a factor on its colour.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface_uniforms.glsl"
#include "optics.glsl"
#include "slopes.glsl"

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2) uniform sampler2DArray waveDerivatives;
#ifdef SHORE
#define SHORE_BINDING 3
#include "shore.glsl"
#define AFTER_SHORE 5
#else
#define AFTER_SHORE 3
#endif
#ifdef SUN_SHADOW
#define SUN_SHADOW_BINDING AFTER_SHORE
#include "sun_shadow.glsl"
#endif

layout(location = 0) out vec4 outColor;

layout(constant_id = 0) const int searchSteps = 2;
layout(constant_id = 1) const uint dryRooms = 0;   // water/dry_rooms.h: roomsPacked()

#include "dry_rooms.glsl"

// All that is scattered, forwards too [1/m]: particles send 0.0183 of it back (Petzold 1972), and molecules, which sea
// water owes this much to (Morel 1974), half.
vec3 scattering() {
    vec3 byMolecules = min(backscatter.rgb, vec3(0.00046, 0.00095, 0.00227));
    return 2.0 * byMolecules + (backscatter.rgb - byMolecules) / 0.0183;
}

// How far the sun's ray through a surface of this slope strays sideways on each metre down.
vec2 strays(vec2 slope) {
    vec3 ray = refract(-toSun.xyz, normalOf(slope), 1.0 / waterIndex);
    return ray.xz / max(-ray.y, 0.1);
}

// How much more a slope turns the ray than under a sun overhead, by a quarter: most along the sun's own direction.
float turnsMore() {
    vec2 towards = horizontal(toSun.xyz);
    return length(strays(0.05 * towards) - strays(-0.05 * towards)) / (0.1 * 0.25);
}

// Mean slopes over `width` metres, of three places: one loop for all is the cheapest.
mat3x2 slopesOver(mat3x2 calm, float width) {
    mat3x2 sum = mat3x2(0.0);
#ifdef SHORE
    mat3x4 kept;
    for (int j = 0; j < 3; ++j) {
        ShoreWave shore = shoreWave(calm[j], width);
        sum[j] = shore.slope;
        kept[j] = shore.kept;
    }
#endif
    int i = 0;
    do {
        float mip = max(log2(width * cascade[i].w), 0.0);
        if (mip < maxMip)
            for (int j = 0; j < 3; ++j) {
                vec2 slope = textureLod(waveDerivatives, vec3(cascade[i].xy + calm[j] * cascade[i].z, i), mip).xy;
#ifdef SHORE
                slope *= kept[j][i];
#endif
                sum[j] += slope;
            }
    } while (++i < stored.cascades);
    return sum;
}

// Where on the surface the rays came through that light places `depth` below: by steps, each from the slope that the last
// one found.
mat3x2 enteredAt(mat3x2 at, float depth, float width) {
    vec2 straight = strays(vec2(0.0));
    mat3x2 from;
    for (int j = 0; j < 3; ++j) from[j] = at[j] - depth * straight;
    int i = 0;
    do {
        mat3x2 slopes = slopesOver(from, width);
        for (int j = 0; j < 3; ++j) from[j] = at[j] - depth * strays(slopes[j]);
    } while (++i < searchSteps);
    return from;
}

// Light on an area comes from that of the surface which it is drawn from. The way back is one to one and the waves repeat,
// so that it is 1 in the mean, to the last place but for what is cut at 0.
float gathered(vec2 at, float depth, float width) {
    float apart = 0.5 * width;
    mat3x2 from = enteredAt(mat3x2(at, at + vec2(apart, 0.0), at + vec2(0.0, apart)), depth, width);
    vec2 u = from[1] - from[0];
    vec2 v = from[2] - from[0];
    return max((u.x * v.y - u.y * v.x) / (apart * apart), 0.0);
}

// Of what lights a point, the sun's share: as its side faces it, less what is scattered on the way.
vec3 beamShare(vec3 at, float depth, vec3 normal) {
    vec3 sun = sunSeen * sunIrradiance.rgb * max(dot(normal, toSun.xyz), 0.0);
    return sun / max(sun + skyIrradiance.rgb, 1e-6) * exp(-scattering() * depth);
}

// Of the sun's light, what came in where the ray to a point did: what stands in the water hides little of it.
float sunSeenFrom(vec3 at, float depth) {
#ifdef SUN_SHADOW
    vec2 from = at.xz - depth * strays(vec2(0.0));
    return sunSeenAt(vec3(from.x, -plane.w, from.y));
#else
    return 1.0;
#endif
}

// Over which waves are taken together: what is too narrow to be seen, what the sun's disc blurs, and what has crossed. An eye
// in the air looks through waves, by which one pixel shows places some deviations of their slopes apart.
float seenWidth(vec3 at, float depth) {
    float disc = 0.0093 / waterIndex * depth;
    float crossed = exp2(caustics.y + caustics.z * log2(depth * turnsMore()));
    float bent = plane.w > 0.0 ? 4.0 * (1.0 - 1.0 / waterIndex) * roughness.w * depth : 0.0;
    return max(max(max(1.5 * pixelWidth(at) + bent, disc), crossed), 1e-3);
}

void main() {
    loadSurface();
    float seen = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec4 q = relativeFromPixel * vec4(gl_FragCoord.xy - vec2(region.xy), seen, 1.0);
    vec3 at = q.xyz / q.w;
    vec3 across = cross(dFdx(at), dFdy(at));   // the side it shows, which depth tells between pixels
    vec3 normal = across * (dot(across, sightTo(at)) > 0.0 ? -1.0 : 1.0) / max(length(across), 1e-12);
    float depth = -(at.y + plane.w);
    bool beside = any(lessThan(at.xz, covered.xy)) || any(greaterThan(at.xz, covered.zw));
    bool below = depthSign * (seen - farDepth) > 0.0 && depth > 0.0 && !beside;
    vec3 factor = vec3(1.0);
    const float leastSeen = 0.004;   // a step of eight bits, where light gathers to twice its mean
    bool lit = below && any(greaterThan(caustics.x * beamShare(at, depth, normal), vec3(leastSeen)));
    if (lit) sunSeen = sunSeenFrom(at, depth);
    vec3 weight = caustics.x * beamShare(at, depth, normal);
    if (lit && sunSeen > 0.0 && !isDry(at))
        factor += weight * (gathered(at.xz, depth, seenWidth(at, depth)) - 1.0);
    if (!below) discard;
    outColor = vec4(factor, dot(factor, vec3(1.0 / 3.0)));
}
