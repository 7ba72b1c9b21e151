// What the waves make of the sunlight on the opaque scene below them, as a factor on its colour.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface_uniforms.glsl"
#include "optics.glsl"
#include "slopes.glsl"
#include "footprint.glsl"
#include "near_plane.glsl"
#include "caustic_light.glsl"

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2) uniform sampler2D gathered;
#ifdef SUN_SHADOW
#define SUN_SHADOW_BINDING 3
#include "sun_shadow.glsl"
#endif

layout(location = 0) out vec4 outColor;

layout(constant_id = 1) const uint dryRooms = 0;   // water/dry_rooms.h: roomsPacked()

#include "dry_rooms.glsl"

// All that is scattered, forwards too [1/m]: particles send 0.0183 of it back (Petzold 1972), and molecules, which sea
// water owes this much to (Morel 1974), half.
vec3 scattering() {
    vec3 byMolecules = min(backscatter.rgb, vec3(0.00046, 0.00095, 0.00227));
    return 2.0 * byMolecules + (backscatter.rgb - byMolecules) / 0.0183;
}

// Deviation along any axis of the slopes that rays do not know of.
float lostSlope(float width) {
    float place = clamp(log2(width) + 7.0, 0.0, 6.99);
    int i = int(place);
    return mix(stored.lostSlopes[i >> 2][i & 3], stored.lostSlopes[i + 1 >> 2][i + 1 & 3], fract(place));
}

// Deviations on each metre down, along the sun's direction and across it.
vec2 strayed(float slope) {
    return slope * stored.sunTurned.xy;
}

// Pixels to the ends of two deviations, which span an ellipse.
struct Spread {
    vec2 along, across;
};

// Of a metre on a level bed, along the sun's direction and across it.
Spread pixelsPerMetre(vec3 at) {
    vec2 towards = horizontal(toSun.xyz);
    vec4 p = pixelOf(at);
    vec4 along = pixelFromRelative * vec4(towards.x, 0.0, towards.y, 0.0);
    vec4 across = pixelFromRelative * vec4(-towards.y, 0.0, towards.x, 0.0);
    return Spread((along.xy - p.xy * along.w) / p.w, (across.xy - p.xy * across.w) / p.w);
}

Spread spreadOf(Spread perMetre, vec2 deviation) {
    return Spread(perMetre.along * deviation.x, perMetre.across * deviation.y);
}

// On each metre down, of where light falls: by the sun's disc, by slopes that rays do not know of and, for an eye in the air, by
// the waves that it looks through.
vec2 blurPerMetre(vec3 at) {
    const float disc = 0.5 * 0.00465 / waterIndex;
    vec2 turned = strayed(lostSlope(rayWidth(at)));
    float shown = onNearPlane().y + plane.w > 0.0 ? 0.25 * roughness.w : 0.0;
    return sqrt(turned * turned + disc * disc + shown * shown);
}

// Light and what it would be under calm water, as a mean of such a spread.
vec2 lightAround(vec2 pixel, Spread spread) {
    Footprint ellipse = footprintOf(spread.along, spread.across);
    float texel = float(rayStep);
    float most = length(ellipse.longer), least = length(ellipse.shorter);
    // A linear look at texels of w has a deviation of 0.41 w. One that is a little wider hides that rays stand in rows.
    const float leastBlurred = 1.6;
    float lod = log2(max(least / (0.41 * texel), leastBlurred));
    const int mostLooks = 4;
    int looks = clamp(int(ceil(most / max(least, 0.41 * texel))), 1, mostLooks);
    // Of an even row from end to end the deviation is 0.29 of its length.
    vec2 row = ellipse.longer * sqrt(max(most * most - least * least, 0.0)) / (0.29 * max(most, 1e-6));
    vec2 size = texel * vec2(textureSize(gathered, 0));
    vec2 sum = vec2(0.0);
    int i = 0;
    do {
        vec2 look = pixel + row * ((float(i) + 0.5) / float(looks) - 0.5);
        sum += textureLod(gathered, look / size, lod).xy;
    } while (++i < looks);
    return sum / float(looks);
}

// Share of the rays that light a pixel which come from where any were cast: fewer by the view's border.
float shareCast(vec2 pixel, Spread spread) {
    vec2 deviation = max(sqrt(spread.along * spread.along + spread.across * spread.across), 1e-3);
    vec2 before = (pixel + float(margin)) / deviation;
    vec2 after = (vec2(region.zw) - pixel + float(margin)) / deviation;
    const float asGoodAsAll = 4.0;
    if (all(greaterThan(min(before, after), vec2(asGoodAsAll)))) return 1.0;
    return (gaussianBelow(before.x) + gaussianBelow(after.x) - 1.0) * (gaussianBelow(before.y) + gaussianBelow(after.y) - 1.0);
}

// Times as much as under calm water.
float lightOn(vec3 at, float depth) {
    vec2 pixel = gl_FragCoord.xy - vec2(region.xy);
    Spread perMetre = pixelsPerMetre(at);
    vec2 light = lightAround(pixel, spreadOf(perMetre, depth * blurPerMetre(at)));
    float elsewhere = 1.0 - shareCast(pixel, spreadOf(perMetre, depth * strayed(roughness.w)));
    return light.y > 0.01 ? light.x / light.y + elsewhere : 1.0;
}

// Of the sun's light what is not scattered on the way.
vec3 straightOn(float depth) {
    return exp(-scattering() * (depth / stored.sunInWater.y));
}

// Of what lights a point the sun's share, as its side faces the bent ray.
vec3 sunShare(vec3 normal) {
    vec3 from = stored.sunInWater.xyz;
    vec3 sun = sunSeen * sunIrradiance.rgb * (toSun.y * max(dot(normal, from), 0.0) / from.y);
    return sun / max(sun + skyIrradiance.rgb, 1e-6);
}

// Of the sun's light, what came in where the ray to a point did: what stands in the water hides little of it.
float sunSeenFrom(vec3 at, float depth) {
#ifdef SUN_SHADOW
    return sunSeenAt(at + stored.sunInWater.xyz * (depth / stored.sunInWater.y));
#else
    return 1.0;
#endif
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
    if (!below) discard;
    vec3 factor = vec3(1.0);
    const float leastSeen = 0.004;   // a step of eight bits, where light gathers to twice its mean
    vec3 straight = caustics.x * straightOn(depth);
    bool lit = any(greaterThan(straight * sunShare(normal), vec3(leastSeen)));
    if (lit) sunSeen = sunSeenFrom(at, depth);
    if (lit && sunSeen > 0.0 && !isDry(at)) factor += straight * sunShare(normal) * (lightOn(at, depth) - 1.0);
    outColor = vec4(factor, dot(factor, vec3(1.0 / 3.0)));
}
