// Light that enters a wave's back, is scattered forwards in it and leaves by its front: quasi-single scattering (Gordon
// 1973: what goes straight on is not lost) along the line of sight as far as the wave stands above the sea's mean level. Below a level surface light comes down steeper than 41
// degrees and is seen from as steep, so that it turns by 83 at least: what turns by less is of crests alone, and what turns
// by more is waterGlow()'s.
#ifndef SUBSURFACE_SCATTERING_GLSL
#define SUBSURFACE_SCATTERING_GLSL

#include "refraction.glsl"
#include "visible_slopes.glsl"
#include "foam_cover.glsl"
#include "surface_mirror.glsl"
#include "waves_ahead.glsl"
#include "surface_point.glsl"
#include "wave_displacement.glsl"
#include "water_light.glsl"

// Henyey and Greenstein's, whose backward share is Petzold's 0.0183 with this g (Mobley 1994, 3.8), above its value where
// light turns by more than a level sea can hide.
float scattersForwards(float cosine) {
    const float g = 0.9185;
    const float levelSeas = 0.00607;
    float d = 1.0 + g * g - 2.0 * g * cosine;
    return max((1.0 - g * g) / (4.0 * pi) / (d * sqrt(d)) - levelSeas, 0.0);
}

// The same over the 49 degrees around a facet's inward normal that light fills behind it, less what Fresnel turns back; the
// line of sight has the cosine `c` to that normal. A fit, within a fifth from 55 to 115 degrees.
float scattersFromFacet(float c) {
    return min(0.0049 * exp(5.0 * c) * clamp(2.5 * (c + 0.66), 0.0, 1.0), 0.9);
}

// Facets that a ray of this steepness (rise over run, from their mean plane) meets lean towards it, of slopes with this
// deviation (Gaussian, within 3 %): mean slope towards it, and what a level square metre of them catches.
float leansTo(float steepness, float deviation) {
    return deviation * deviation / sqrt(steepness * steepness + 0.64 * deviation * deviation);
}
float catches(float steepness, float deviation) {
    return 0.5 * (steepness + sqrt(steepness * steepness + 0.64 * deviation * deviation));
}

// The wave's far side towards a horizontal direction, as a plane `above` a point.
struct CrestSide {
    vec2 towards;
    float rises;   // a metre
    float above;   // [m]
};

// Of the wave over a point: its sides towards two directions.
struct Crest {
    CrestSide one, other;
};

// The front of a shore's breaker rises nearly as fast as the sun's ray does in water: where a line through two taps says that the
// ray leaves, another finds what the wave is like there. Taps are at where its waves have moved them to: nearer to each other at crests.
Crest crestOver(const SurfacePoint s, vec2 calm, float height, vec2 one, vec2 other, float width) {
    const int taps = hasShore ? 4 : 3;
    float least = max(width, 1e-3);   // of what touches the surface, where a ray has no way through it [m]
    float over = 0.0, apart = 0.0;
    vec2 aside = vec2(0.0);     // of what waves move, from what they move where the pixel is
    vec2 last = vec2(0.0);      // how far towards that side, and how high
    vec2 rises = vec2(0.0);
    float above = 0.0;
    int i = 0;
    // To the other side second: all taps share one copy of the code.
    [[dont_unroll]] do {
        vec2 towards = i == 1 ? other : one;
        vec3 there = surfaceDisplacement(waveDisplacement, calm + apart * towards - aside, width);
        vec2 found = vec2(apart, there.y - height);
        if (hasShore && i > 0) {
            vec2 now = there.xz - (s.position.xz - s.calm);
            found.x += dot(now - aside, towards);
            aside = now;
        }
        if (i == 0) {
            over = found.y;
            apart = max(over, least);
        }
        if (i < 3) last = vec2(0.0, over);
        float step = found.x - last.x;
        float nearest = hasShore ? 0.5 * least : least;
        step = hasShore && step < 0.0 ? min(step, -nearest) : max(step, nearest);
        rises = vec2(clamp((found.y - last.y) / step, -1.0, 1.0), i < 3 ? rises.x : rises.y);
        if (hasShore) above = max(last.y - rises.x * last.x, 0.0);
        if (hasShore && i == 2) {
            float leaves = min(above / max(sunInWater().y / max(length(sunInWater().xz), 1e-3) - rises.x, 0.1), 4.0 * apart);
            apart = leaves < found.x ? min(leaves, found.x - least) : max(leaves, found.x + least);
            last = found;
        }
    } while (++i < taps);
    over = max(over, 0.0);
    return Crest(CrestSide(one, rises.x, hasShore ? above : over), CrestSide(other, rises.y, over));
}

vec3 normalOf(CrestSide side, float lean) {
    return normalOf((side.rises - lean) * side.towards);
}

// How much faster a ray rises than that side: metres of height a metre.
float risesFaster(CrestSide side, vec3 from) {
    return max(from.y - side.rises * length(from.xz), 0.1);
}

// The sun's beam through that side, above `calm`: irradiance of what faces it, times the share that turns to the eye.
vec3 sunScattered(const SurfacePoint s, CrestSide side, vec2 calm, vec3 along) {
    vec3 toSun = sunDirection(s);
    float level = length(toSun.xz);
    float tangent = toSun.y / max(level, 1e-3);
    float steepness = tangent - side.rises;
    vec3 facet = normalOf(side, leansTo(steepness, slopeDeviation()));
    float cosSun = dot(facet, toSun);
    bool isLit = toSun.y > 0.0 && cosSun > 0.0;
    vec3 from = -refract(-toSun, facet, 1.0 / waterIndex);
    float rises = risesFaster(side, from);
    float beam = max(level, 1e-3) * catches(steepness, slopeDeviation()) * (1.0 - fresnelWater(cosSun)) / rises;
    float way = side.above / rises;
    vec3 light = sunLight(s.sunSeen) * exp(-extinction() * way);
    float share = beam * scattersForwards(dot(from, along)) / (waterIndex * waterIndex);
    // Most of a wave's front looks up to its crest, which hides the sun from where light would enter. Where no waves are
    // looked for, a side that rises faster than the sun's rays is taken to be in shadow; those of a shore's trains never are.
    if (!wavesAreLookedFor() || hasShore) share *= smoothstep(-0.1, 0.15, steepness);
    if (wavesAreLookedFor() && isLit && share * dot(light, vec3(1.0)) > 1e-5 * dot(sunLight(1.0), vec3(1.0))) {
        share *= pastHorizon(tangent, horizonTowards(s, calm + from.xz * way, side.towards, tangent));
    }
    return isLit ? share * light : vec3(0.0);
}

// Along which the eye looks into the water, through the facets that it sees.
vec3 intoWater(const SurfacePoint s, vec3 toEye) {
    vec2 towards = horizontal(toEye);
    float deviation = sqrt(max(varianceAlong(towards, s.covariance), 0.0) + 1e-8);
    float steepness = toEye.y / max(length(toEye.xz), 1e-3) - dot(s.slope, towards);
    return refract(-toEye, normalOf(s.slope - towards * leansTo(steepness, deviation)), 1.0 / waterIndex);
}

// `behind` as the water before it leaves it, `path` metres of it. Where all around is of one radiance it stays so. `plume`: of
// bubbles, which scatter as particles do.
vec3 throughScattering(vec3 behind, const SurfacePoint s, vec3 toEye, float path, float plume) {
    const float byBubbles = 2.0;   // where a wave has just broken [1/m]
    int points = pointsLit();
    float scattering = scatteredByParticles() + byBubbles * plume;
    float bottom = s.height + heightDeviation();
    if (bottom > 0.0) {
        vec3 along = intoWater(s, toEye);
        vec2 ahead = horizontal(along);
        vec3 lowSky = normalize(vec3(ahead.x, 0.6, ahead.y));
        float stretch = min(path, bottom / max(-along.y, 0.3)) / float(points);
        float width = 0.5 * stretch;
        float straight = 1.0;   // share that has not turned to the sky
        vec3 fromSun = vec3(0.0);
        vec3 skyShare = vec3(0.0);
        int i = 0;
        do {
            float t = (float(i) + 0.5) * stretch;
            vec2 calm = s.calm + along.xz * t;
            vec3 reaches = straight * exp(-extinction() * t);
            Crest crest = crestOver(s, calm, s.height + along.y * t, horizontal(sunDirection(s)), ahead, width);
            fromSun += scattering * stretch * reaches * sunScattered(s, crest.one, calm, along);
            CrestSide far = crest.other;
            // Facets of a rough side spread its light: e^(5 c) over the deviation of their tilt.
            float share = scattersFromFacet(dot(normalOf(far, 0.0), along)) * exp(12.5 * slopeDeviation() * slopeDeviation());
            float turned = 1.0 - exp(-scattering * stretch * share);
            skyShare += turned * reaches * exp(-extinction() * (far.above / risesFaster(far, lowSky)));
            straight *= 1.0 - turned;
        } while (++i < points);
        behind += skyShare * (throughAir(skyAt(s, lowSky, 0.5), s.air) - behind) + throughAir(fromSun, s.air);
    }
    return behind;
}

#endif
