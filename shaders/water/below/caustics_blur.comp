// Spreads what rays left of light as far as what they do not know of would: slopes finer than they see, the sun's disc and, for an
// eye in the air, the waves that it looks through.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "body.glsl"
#include "optics.glsl"
#include "slopes.glsl"
#include "footprint.glsl"
#include "near_plane.glsl"
#include "caustic_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = causticLightBinding) uniform sampler2DArray gathered;   // of one layer
layout(set = 0, binding = causticSumsBinding, std430) writeonly buffer Light {
    uint blurred[];   // halves, in the place of the sums
};
#include "sun_shadow.glsl"

// Deviation along any axis of the slopes that rays do not know of.
float lostSlope(float width) {
    float place = clamp(log2(width) + 7.0, 0.0, 6.99);
    int i = int(place);
    return mix(water.lostSlopes[i >> 2][i & 3], water.lostSlopes[i + 1 >> 2][i + 1 & 3], fract(place));
}

// Deviations on each metre down, along the sun's direction and across it.
vec2 strayed(float slope) {
    return slope * water.sunTurned.xy;
}

// Pixels to the ends of two deviations, which span an ellipse.
struct Spread {
    vec2 along, across;
};

// Of a metre on a level bed, along the sun's direction and across it.
Spread pixelsPerMetre(vec3 at) {
    vec2 towards = horizontal(sunAtEye());
    vec4 p = pixelOf(at);
    vec4 along = homogeneousPerMetre(vec3(towards.x, 0.0, towards.y));
    vec4 across = homogeneousPerMetre(vec3(-towards.y, 0.0, towards.x));
    return Spread((along.xy - p.xy * along.w) / p.w, (across.xy - p.xy * across.w) / p.w);
}

Spread spreadOf(Spread perMetre, vec2 deviation) {
    return Spread(perMetre.along * deviation.x, perMetre.across * deviation.y);
}

// On each metre down, of where light falls: by the sun's disc, by slopes that rays do not know of and, for an eye in the air, by
// the waves that it looks through.
vec2 blurPerMetre(vec2 pixel, vec3 at) {
    const float disc = 0.5 * 0.00465 / waterIndex;
    vec2 turned = strayed(lostSlope(rayWidth(at)));
    float shown = heightOverCalm(onNearPlane(pixel)) > 0.0 ? 0.25 * slopeDeviation() : 0.0;
    return sqrt(turned * turned + disc * disc + shown * shown);
}

// The mean over such a spread.
vec2 lightAround(vec2 pixel, Spread spread) {
    Footprint ellipse = footprintOf(spread.along, spread.across);
    float texel = float(rayStep());
    // A linear tap of texels of w has a deviation of 0.41 w. One that is a little wider hides that rays stand in rows.
    float most = length(ellipse.longer), least = max(length(ellipse.shorter), 1.6 * 0.41 * texel);
    float lod = log2(least / (0.41 * texel));
    const int mostTaps = 4;
    int taps = int(clamp(ceil(most / least), 1.0, float(mostTaps)));
    // Of an even row from end to end the deviation is 0.29 of its length.
    vec2 row = ellipse.longer * sqrt(max(most * most - least * least, 0.0)) / (0.29 * max(most, 1e-6));
    vec2 size = texel * vec2(textureSize(gathered, 0).xy);
    // From there the widest tap, of the last mip, ends 48 texels on: where what has been gathered does, `reach` of water/below/caustics.cpp.
    vec2 last = texel * (vec2(lightSize()) + 16.0);
    vec2 sum = vec2(0.0);
    int i = 0;
    do {
        vec2 tap = pixel + row * ((float(i) + 0.5) / float(taps) - 0.5);
        sum += textureLod(gathered, vec3(min(tap, last) / size, 0.0), lod).xy;
    } while (++i < taps);
    return sum / float(taps);
}

// Share of the rays that light a pixel which come from where any were cast: fewer by the view's border.
float shareCast(vec2 pixel, Spread spread) {
    vec2 deviation = max(sqrt(spread.along * spread.along + spread.across * spread.across), 1e-3);
    vec2 before = (pixel + float(margin())) / deviation;
    vec2 after = (vec2(regionSize()) - pixel + float(margin())) / deviation;
    const float asGoodAsAll = 4.0;
    if (all(greaterThan(min(before, after), vec2(asGoodAsAll)))) return 1.0;
    return (gaussianBelow(before.x) + gaussianBelow(after.x) - 1.0) * (gaussianBelow(before.y) + gaussianBelow(after.y) - 1.0);
}

// Of the sun's light, what came in where the ray to a point did: what stands in the water hides little of it.
float sunSeenFrom(vec3 at) {
    return hasSunShadow ? sunSeenAt(sunRayEnters(at)) : 1.0;
}

// By how much of what calm water lets through there is more light, which halves hold most exactly where it is faint, and what
// nothing hides of the sun, in the middle of a texel. What shows no bed takes part in what is beside it.
vec2 lightOn(ivec2 texel) {
    vec2 pixel = (vec2(texel) + 0.5) * float(rayStep());
    Spread blur = Spread(vec2(0.0), vec2(0.0));
    float elsewhere = 0.0, seen = 1.0;
    vec3 at;
    if (bedShownAt(sceneDepth, min(pixelOfTexel(texel), regionSize() - 1), at)) {
        float depth = -heightOverCalm(at);
        Spread perMetre = pixelsPerMetre(at);
        blur = spreadOf(perMetre, depth * blurPerMetre(pixel, at));
        elsewhere = 1.0 - shareCast(pixel, spreadOf(perMetre, depth * strayed(slopeDeviation())));
        seen = sunSeenFrom(at);
    }
    vec2 light = lightAround(pixel, blur);
    return vec2(light.y > 0.01 ? light.x / light.y + elsewhere - 1.0 : 0.0, seen);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, max(firstRow(), 0));
    if (any(greaterThanEqual(texel, lightSize()))) return;
    blurred[texel.y * rowLength() + texel.x] = packHalf2x16(lightOn(texel));
}
