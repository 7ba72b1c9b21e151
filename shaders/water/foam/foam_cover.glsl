// Foam on the surface: its cover from the waves' history, broken up by a pattern, and its light.
#ifndef FOAM_COVER_GLSL
#define FOAM_COVER_GLSL

#include "sun_glint.glsl"
#include "water_light.glsl"
#include "turns.glsl"
#include "surface_fog.glsl"
#include "wave_displacement.glsl"
#include "surface_point.glsl"
#include "foam_gate.glsl"
#include "foam_tiles.h"

struct Foam {
    float mask;    // share that is white
    float fresh;   // 1 where waves break, less as what they leave thins
    vec2 slope;    // of its own bumps
    float height;  // of the white's own, -1..1 and 0 in the mean: more light reaches what stands out
    float plume;   // bubbles in the water below: 1 where it has just broken, less as they rise and thin
};

const float filmVariance = 0.12;   // of the slopes of the film that foam is wet with

// What breakers leave; the edge of the water, wide and white where it rushes up; what it lays down where it turns, in lobes, as
// much as `bend`, -1..1, moves the edge of that.
float shoreFoam(const ShoreSeen shore, float bend) {
    float thick = shore.thick + 0.012 * bend;
    vec2 x = vec2((thick - 0.025) / 0.025, thick / 0.12);
    vec2 bells = exp(-x * x);
    float wet = shore.wet + 0.15 * bend;
    float rim = smoothstep(0.0, 0.12, wet) * (1.0 - smoothstep(0.15, 0.45, wet));
    float left = thick > 0.0 ? (0.35 + 0.65 * shore.rushes) * bells.x + 0.5 * shore.rushes * bells.y : 0.7 * rim;
    left *= shore.swash;
    return 1.0 - (1.0 - 0.95 * surfFoam(shore.breakers, bend)) * (1.0 - min(left, 0.9));
}

// Share of the places where a sum of three even distributions, of these widths and of mean 0, is below `x`.
float shareBelow(float x, vec3 widths) {
    float t = max(0.5 * (widths.x + widths.y + widths.z) - abs(x), 0.0);   // from its end
    vec3 one = max(t - widths, 0.0);
    vec3 two = max(t - widths - widths.yzx, 0.0);
    float tail = (t * t * t - dot(one * one, one) + dot(two * two, two)) / (6.0 * widths.x * widths.y * widths.z);
    return x < 0.0 ? tail : 1.0 - tail;
}

// Share of the pixel where waves break at this moment: where they are compressed most, all cascades together. Compression is a
// Gaussian, so that the mean is kept however much a pixel shows (Dupuy and Bruneton 2012).
//
// What is compressed is narrow, and counts for less as seen from above: where it is too small to be seen, by the last factor.
float breakingNow(const SurfacePoint s) {
    float hidden = water.breaking.z * s.compressed.y;
    float share = gaussianBelow((s.compressed.x - water.breaking.x) * inversesqrt(water.breaking.y + hidden));
    // Most of it lies where the history is white already: as much as that is taken off where a pixel hides what lies where.
    share *= mix(1.0, water.compression.w, hidden / (water.breaking.y + hidden));
    return share * max(1.0 - water.breaking.w * s.compressed.y, 0.0);
}

// Where foam can be: foam_gate.glsl, and what of it breaks now.
struct Whitecaps {
    float gate;
    float now;
};

// Share of the surface that is white: what breakers left, of which each cascade has a factor (water/foam/foam_history.h), and
// what breaks; and what plume of bubbles is below. `bend`, -1..1, moves the place looked up by as much as hides that the history
// has samples.
vec2 foamCover(const SurfacePoint s, vec2 aside, vec2 bend, float pixelWidth, Whitecaps caps) {
    vec2 foamy = vec2(caps.gate);
    vec2 calm = s.calm + aside;
    vec2 under = warped(calm);
    for (int i = 0; i < foamCascades; ++i) {
        float texels = texelsInAMetre(i);
        vec2 place = under + bend * min(0.7 / texels, 4.0);
        float mip = log2(max(pixelWidth * texels, 1.0));
        vec3 at = inTile(place, i) - vec3(water.foamDrift[i].xy, 0.0);
        vec4 steps = textureLod(foamHistory, at, mip);
        vec2 left = mix(vec2(1.0 - steps.x, steps.z), vec2(1.0 - steps.y, steps.w), vec2(water.foamStep, water.foamDrift[i].z));
        if (hasShore) left *= s.shore.kept[i] * s.shore.kept[i];
        foamy *= left;
    }
    float clear = (1.0 - foamy.x) * (1.0 - caps.now);
    if (hasShore) clear *= 1.0 - shoreFoam(s.shore, bend.y);
    return vec2(1.0 - clear, max(foamy.y, 1.0 - clear));
}

// Where in the pattern a place looks: a tile seen over and over stands in rows, so each place has its own part of it, by an
// index that changes slowly (Quilez, Texture repetition).
struct FoamPart {
    vec2 here;    // [m]
    vec2 beside;
    vec2 windrows;   // likewise, of the longest tile
    float share;  // of `beside`
};

FoamPart foamPartOf(vec2 place, vec2 windrows) {
    vec2 turn = fract(place / foamRepeat);
    vec3 turns = vec3(7.0 * turn.x + 3.0 * turn.y, 9.0 * turn.y - 5.0 * turn.x, 11.0 * turn.x - 4.0 * turn.y);
    float index = 4.0 + 1.1 * dot(sin(withinHalfTurn(turns + vec3(0.0, 0.1591549, 0.3183099))), vec3(1.0));
    const vec2 spread = foamTile * vec2(0.7548777, 0.5698403);   // over the tile, evenly (Roberts 2018)
    float part = floor(index + 0.5);
    float off = index - part;
    return FoamPart(place + part * spread, place + (part + (off < 0.0 ? -1.0 : 1.0)) * spread, windrows, 0.5 * smoothstep(0.38, 0.5, abs(off)));
}

// Centred on 0. Two parts that meet keep the contrast of one.
vec4 foamPatternAt(FoamPart part, float tile, float mip) {
    vec4 texel = textureLod(foamPattern, part.here / tile, mip) - 0.5;
    if (part.share > 0.0) {
        vec4 beside = textureLod(foamPattern, part.beside / tile, mip) - 0.5;
        texel = mix(texel, beside, part.share) / length(vec2(part.share, 1.0 - part.share));
    }
    return texel;
}

// A place's own in the pattern, which passes more slowly along the wind: so wind draws foam out.
vec2 drawnOut(vec2 calm, vec2 streak) {
    return calm - streak * dot(streak, calm);
}

// Cover breaks up into rafts and lace where they can be seen, drawn out by the wind, and is a mean where they cannot:
// white is a share `cover` of the surface either way.
//
// One tap, `aside` of the pixel's middle on the calm plane. It covers `pixelWidth` there, and `patternWidth` of the pattern [m].
Foam foamAt(const SurfacePoint s, vec2 aside, FoamPart part, float pixelWidth, vec2 patternWidth, Whitecaps caps) {
    const vec3 weights = vec3(0.33, 0.39, 0.28);   // of windrows, rafts and lace
    const vec3 tiles = vec3(windrowTile, foamTile, foamTile / 7.0);
    const float patternSamples = 256.0;
    const float patternMips = 8.0;   // beyond the finest
    const float patternSquares = dot(weights, weights);   // twelve variances of even distributions
    const float softEdges = 0.2;   // share of it, so that rafts' edges fade out over half a deviation
    float pattern = 0.0;
    float squares = 0.0;
    vec3 widths;
    vec2 slope = vec2(0.0);
    float bend[3];
    float inWindrows;
    for (int i = 0; i < 3; ++i) {
        float texels = i == 0 ? max(patternWidth.x * patternSamples / windrowTile, 4.0)   // finer lines would look combed
                              : max(patternWidth.y * patternSamples / tiles[i], 1.0);
        float mip = log2(texels);
        vec4 texel = i == 0 ? textureLod(foamPattern, part.windrows / windrowTile, mip) - 0.5 : foamPatternAt(part, tiles[i], mip);
        // The last mip has no contrast, and a byte for it that is not quite the mean.
        float last = clamp(patternMips - mip, 0.0, 1.0);
        float kept = weights[i] * last * last * 30.0 / (29.15 + texels);   // keptContrast() of water/foam/foam_pattern.cpp
        pattern += weights[i] * last * texel.x;
        squares += kept * kept;
        widths[i] = kept;
        slope += texel.zw;
        bend[i] = 2.0 * texel.y;
        if (i == 0) inWindrows = last * texel.x;
    }
    vec2 found = foamCover(s, aside, vec2(bend[0] + 0.4 * bend[2], bend[1] - 0.4 * bend[2]), pixelWidth, caps);
    float cover = found.x;
    float streaks = 1.0 - 1.2 * inWindrows;   // as foam does, bubbles gather there
    // Mips that are looked at between their texels have longer ends than even distributions do.
    widths = max(widths, 0.15 * (widths.x + widths.y + widths.z) + 1e-3);
    // As its own distribution function the octaves' sum is even again, so that a share `cover` of it lies below `cover`.
    // Its ends are kept off 0 and 1, where even no foam at all would show.
    float even = clamp(shareBelow(pattern, widths), 2e-4, 1.0 - 2e-4);
    // What the tap blurs away is noise to it, as are soft edges: of that noise as much lies below as makes a share `cover` of
    // all taps white, however little of the pattern is left.
    float kept2 = (1.0 - softEdges) * squares / patternSquares;
    float white = gaussianBelow((gaussianQuantile(cover) - sqrt(kept2) * gaussianQuantile(even)) * inversesqrt(1.0 - kept2));
    // Where white is but likely, where it stands out is no longer told.
    return Foam(white, cover, slope, kept2 * kept2 * clamp(1.0 - 2.0 * even / max(cover, 1e-3), -1.0, 1.0), min(streaks * found.y, 1.0));
}

// A pixel is long and narrow at a grazing angle, and is taken in as many parts as there are taps of its waves. A tap is
// as wide as such a part at its narrow side, or half its longer one: as wide as all of it, rafts blur into a veil.
Foam foamOver(const SurfacePoint s) {
    vec2 calm = s.calm;
    if (hasShore) calm -= s.shore.advected;
    vec2 streak = water.foamStreak, windrow = water.windrows.xy;
    vec2 under = warped(s.calm);
    vec2 wander = under - s.calm;   // as the waves do, so that windrows are not straight, and no tile stands in rows
    FoamPart here = foamPartOf(water.foamPlace + drawnOut(calm, streak), water.windrows.zw + drawnOut(calm + wander, windrow));
    Footprint pixel = s.footprint;
    vec2 part = partOf(pixel);
    vec2 wide = part * clamp(length(pixel.shorter) / max(length(part), 1e-9), 0.5, 1.0);
    float width = max(length(wide), length(pixel.shorter));
    vec2 patternWidth = vec2(max(length(drawnOut(wide, windrow)), length(drawnOut(pixel.shorter, windrow))),
                             max(length(drawnOut(wide, streak)), length(drawnOut(pixel.shorter, streak))));
    float gate = foamGate(under, width);
    Whitecaps caps = Whitecaps(gate, gate * breakingNow(s));
    Foam sum = Foam(0.0, 0.0, vec2(0.0), 0.0, 0.0);
    int parts = partsOfPixel();
    int i = 0;
    do {
        vec2 aside = part * partsAside(i);
        vec2 drawn = drawnOut(aside, streak);
        FoamPart there = FoamPart(here.here + drawn, here.beside + drawn, here.windrows + drawnOut(aside, windrow), here.share);
        Foam tap = foamAt(s, aside, there, width, patternWidth, caps);
        sum.mask += tap.mask;
        sum.fresh += tap.fresh;
        sum.slope += tap.slope;
        sum.height += tap.height;
        sum.plume += tap.plume;
    } while (++i < parts);
    float each = 1.0 / float(parts);
    return Foam(each * sum.mask, each * sum.fresh, each * sum.slope, each * sum.height, each * sum.plume);
}

// Radiance of the bubbles that waves broke into the water, just above its surface. The upper ones rise and are gone first, so that
// what is left shines through more water: blue-green, then blue.
vec3 plumeGlow(vec3 toSun, float sunSeen, float plume) {
    const float reflects = 0.13;
    float throughWater = mix(12.0, 2.5, plume);   // there and back [m]
    vec3 light = sunSeen * sunEntering(toSun) + skyEntering();
    return light * (reflects / pi * plume) * exp(-throughWater * extinction());
}

// The surface of what foam is wet with.
SurfacePoint filmOn(SurfacePoint s, Foam white) {
    const float bumpiness = 0.7;
    s.slope += bumpiness * white.slope;
    s.covariance += vec3(filmVariance, filmVariance, 0.0);
    return s;
}

// sunGlint() of the water, and of the film on its foam.
vec2 sunGlints(const SurfacePoint s, Foam white, vec3 toEye) {
    if (!hasFoam) return vec2(sunGlint(s, toEye, true), 0.0);
    SurfacePoint seen = s;
    vec2 glints = vec2(0.0);
    int i = 0;
    // Both share one copy of the code.
    [[dont_unroll]] do {
        glints = vec2(glints.y, sunGlint(seen, toEye, i == 0));
        seen = filmOn(s, white);
    } while (++i < 2);
    return glints;
}

// What foam makes of light: of what is bare a share is left.
struct FoamLight {
    vec3 radiance;
    float bare;
};

// Foam scatters light and rises in bubbles and rafts; the film that they are wet with mirrors every way. Of what the
// water mirrors a share shines from it too. As it ages it thins, to what makes whitecaps as bright in the mean as they are
// found, two fifths of fresh foam (Koepke 1984). `ahead`: towards the sun. `glint`: of the film.
FoamLight foamLight(Foam white, const SurfacePoint s, vec3 toEye, vec3 mirrored, WavesAhead ahead, float glint) {
    const float filmShare = 0.4;
    const float thinnest = 0.3;
    vec3 facing = normalOf(filmOn(s, white).slope);
    // What leans sees less of the sky, and what lies low less than what stands out.
    float open = (0.5 + 0.5 * facing.y) * (1.0 + 0.4 * white.height);
    vec3 toSun = sunDirection(s);
    float sun = s.sunSeen * sunClear(toSun, s.slope, ahead) * max(dot(facing, toSun), 0.0);
    ahead.unseen = sqrt(ahead.unseen * ahead.unseen + filmVariance);
    glint *= sunClear(toSun, slopeOf(toEye + toSun), ahead);
    vec3 light = lightBy(sun, open);
    vec3 foamy = throughAir(light * water.foamAlbedo / pi + filmShare * sunLight(glint), s.air) + filmShare * mirrored;
    float share = white.mask * mix(thinnest, 1.0, white.fresh);
    return FoamLight(share * foamy, 1.0 - share);
}

#endif
