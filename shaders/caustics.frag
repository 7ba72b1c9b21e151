// What the waves make of the sunlight on the opaque scene below them, as a factor on its colour.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface_uniforms.glsl"
#include "optics.glsl"
#include "slopes.glsl"
#include "dry_rooms.glsl"

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

// Mean slope over `width` metres.
vec2 slopeOver(vec2 calm, float width) {
    vec2 sum = vec2(0.0);
    float kept = 1.0;
#ifdef SHORE
    ShoreWave shore = shoreWave(calm, width);
    sum = shore.slope;
#endif
    for (int i = 0; i < stored.cascades; ++i) {
        float mip = max(log2(width * cascade[i].w), 0.0);
#ifdef SHORE
        kept = shore.kept[i];
#endif
        // Loops of one round, here and below: CPU devices leave them out where nobody is in them.
        for (bool shows = mip < maxMip; shows; shows = false)
            sum += kept * textureLod(waveDerivatives, vec3(cascade[i].xy + calm * cascade[i].z, i), mip).xy;
    }
    return sum;
}

// Where on the surface the ray came through that lights `at`, `depth` below: by steps, each from the slope that the last
// one found.
vec2 enteredAt(vec2 at, float depth, float width) {
    vec2 from = at - depth * strays(vec2(0.0));
    for (int i = 0; i < 3; ++i) from = at - depth * strays(slopeOver(from, width));
    return from;
}

// Light on an area comes from that of the surface which it is drawn from. The way back is one to one and the waves repeat,
// so that it is 1 in the mean, to the last place but for what is cut at 0.
float gathered(vec2 at, float depth, float width) {
    float apart = 0.5 * width;
    vec2 from = enteredAt(at, depth, width);
    vec2 u = enteredAt(at + vec2(apart, 0.0), depth, width) - from;
    vec2 v = enteredAt(at + vec2(0.0, apart), depth, width) - from;
    return max((u.x * v.y - u.y * v.x) / (apart * apart), 0.0);
}

void main() {
    loadSurface();
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float seen = texelFetch(sceneDepth, pixel, 0).r;
    vec4 q = relativeFromPixel * vec4(gl_FragCoord.xy - vec2(region.xy), seen, 1.0);
    vec3 at = q.xyz / q.w;
    vec3 across = cross(dFdx(at), dFdy(at));
    float depth = -(at.y + plane.w);
    bool beside = any(lessThan(at.xz, covered.xy)) || any(greaterThan(at.xz, covered.zw));
    if (depthSign * (seen - farDepth) <= 0.0 || !(depth > 0.0) || beside || isDry(at)) discard;

    // Of what lights the point, the sun's share: as its side faces it, which depth tells between pixels.
    vec3 normal = across * (dot(across, sightTo(at)) > 0.0 ? -1.0 : 1.0) / max(length(across), 1e-12);
#ifdef SUN_SHADOW
    // By where the ray came in: what stands in the water hides little of it.
    vec2 from = at.xz - depth * strays(vec2(0.0));
    sunSeen = sunSeenAt(vec3(from.x, -plane.w, from.y));
#endif
    vec3 sun = sunSeen * sunIrradiance.rgb * max(dot(normal, toSun.xyz), 0.0);
    vec3 share = sun / max(sun + skyIrradiance.rgb, 1e-6);
    vec3 beam = exp(-scattering() * depth);
    vec3 weight = caustics.x * share * beam;

    // What is too narrow to be seen, what the sun's disc blurs, and what has crossed. An eye in the air looks through waves, by
    // which one pixel shows places some deviations of their slopes apart.
    float disc = 0.0093 / waterIndex * depth;
    float crossed = exp2(caustics.y + caustics.z * log2(depth * turnsMore()));
    float bent = plane.w > 0.0 ? 4.0 * (1.0 - 1.0 / waterIndex) * roughness.w * depth : 0.0;
    float width = max(max(1.5 * pixelWidth(at) + bent, disc), crossed);
    vec3 factor = vec3(1.0);
    const float leastSeen = 0.004;   // a step of eight bits, where light gathers to twice its mean
    for (bool lit = any(greaterThan(weight, vec3(leastSeen))); lit; lit = false)
        factor += weight * (gathered(at.xz, depth, max(width, 1e-3)) - 1.0);
    outColor = vec4(factor, dot(factor, vec3(1.0 / 3.0)));
}
