// What a pixel shows of the surface: all that shading knows of it. Its slope, and what of its waves is too small to be seen
// there: a Gaussian of slopes (Cox and Munk 1954), whose variance is what the mips of the derivatives lost plus what no cascade holds.
#ifndef SURFACE_POINT_GLSL
#define SURFACE_POINT_GLSL

#include "surface.glsl"
#include "footprint.glsl"
#include "optics.glsl"
#include "slopes.glsl"
#include "tile_quad.glsl"
#include "gusts.glsl"

// What shading knows of a shore's bed, and of the trains that it guides: less than ShoreWave, since all of it is kept meanwhile.
struct ShoreSeen {
    vec4 kept;       // of each cascade's amplitude
    float depth;     // of calm water
    vec2 bedSlope;
    float thick;     // how high the water that the bed guides stands over it; less than nothing behind the water's edge [m]
    float wet;       // how far wet sand has been left behind by the water's edge, 1: it has just been there, 0: it is dry
    float rushes;    // how fast the water's edge rises, 0..1
    float swash;     // 1 where that edge moves at all
    vec2 advected;   // what the swash has carried foam by [m]
    Breakers breakers;
};

ShoreSeen shoreSeen(ShoreWave w) {
    ShoreSeen seen;
    seen.kept = w.kept;
    seen.depth = w.depth;
    seen.bedSlope = w.bedSlope;
    seen.thick = w.height + w.depth - dot(w.bedSlope, w.move);
    seen.wet = clamp((w.wetTo + w.depth) / max(0.8 * w.swash, 1e-3), 0.0, 1.0);
    seen.rushes = smoothstep(-0.02, 0.1, w.rushes);
    seen.swash = smoothstep(0.0, 0.02, w.swash);
    seen.advected = w.advected;
    seen.breakers = breakersOf(w);
    return seen;
}

struct SurfacePoint {
    vec2 pixel;         // of the region, its middle
    bool fromWater;     // it is seen from within the water
    bool quadIsAlike;   // all four pixels of the quad show this water, and from the same side
    vec2 calm;          // (u, v) before displacement
    Footprint footprint;   // of the pixel on the calm plane
    float pixelLength;  // to the next pixel [m of calm water]
    vec3 position;
    vec3 overPlane;     // where it was before it sank on a globe
    float height;       // above the calm water [m]
    mat3 level;         // fromLevel()
    ShoreSeen shore;
    vec2 slope;         // mean over the pixel
    vec3 covariance;    // of the slopes within it: uu, vv, uv
    float slopeStep;    // change of slope to the next pixel
    vec2 compressed;    // with foam: the cascades that count, together, by whitecaps.h; variance of slopes that this mean over the pixel hides
    float bounded;      // of the covariance, variance along both axes that ends within the pixel
    float sunSeen;      // share of the sun's light that reaches the surface here
    vec4 air;           // airBefore()
};

// From the axes of what is level at the point. On a globe light is reckoned in these, the sky's too, which is that of each place;
// the eye, the scene and where things are keep the body's axes.
vec3 fromLevel(const SurfacePoint s, vec3 direction) {
    return onGlobe ? s.level * direction : direction;
}

// In those axes.
vec3 sunDirection(const SurfacePoint s) {
    return onGlobe ? sunAtEye() * s.level : sunAtEye();
}

// Share of the surface that is to be seen: nothing of it where it lies dry.
float presence(const ShoreSeen shore) {
    return max(smoothstep(0.0, 0.025, shore.thick), shore.wet);
}

// 1 where the surface is but a film.
float onSand(const ShoreSeen shore) {
    return 1.0 - smoothstep(0.0, 0.04, shore.thick);
}

// What a shore leaves of each cascade's amplitude here.
vec4 keptAt(const SurfacePoint s) {
    return hasShore ? s.shore.kept : vec4(1.0);
}

// At a grazing angle a pixel is long and narrow, and is taken in so many parts.
int partsOfPixel() {
    return slopeSamples;
}

// The longer side of one.
vec2 partOf(Footprint pixel) {
    return pixel.longer / float(slopeSamples);
}

// From the pixel's middle to that of a part, in parts.
float partsAside(int i) {
    return float(i) + 0.5 - 0.5 * float(slopeSamples);
}

// Derivatives of the waves over the pixel, and their moments.
void sampleWaves(vec3 at, int cascade, Footprint pixel, out vec4 derivatives, out vec4 moments) {
    if (slopeSamples == 1) {
        float covered = pixel.reach * texelsInAMetre(cascade);
        float level = log2(max(covered, 1e-6));
        derivatives = textureLod(waveDerivatives, at, level);
        moments = textureLod(waveMoments, at, level);
        return;
    }
    float tiles = tilesInAMetre(cascade);
    derivatives = vec4(0.0);
    moments = vec4(0.0);
    vec2 part = partOf(pixel) * tiles;
    vec2 across = pixel.shorter * tiles;
    for (int i = 0; i < slopeSamples; ++i) {
        vec3 there = at + vec3(part * partsAside(i), 0.0);
        derivatives += textureGrad(waveDerivatives, there, part, across);
        moments += textureGrad(waveMoments, there, part, across);
    }
    derivatives /= float(slopeSamples);
    moments /= float(slopeSamples);
}

// 1 where a pixel of so many texels shows a part of one of a cascade's waves, 0 where it shows many.
float partOfAWave(float texels) {
    return 1.0 - smoothstep(8.0, 32.0, texels);
}

// By the waves at its calm position, and a shore's own. `turn` is tile_quad.glsl's.
void findSlopes(inout SurfacePoint s, WaveGradient ofShore, vec3 unseenOfShore, inout uint turn) {
    s.slope = vec2(0.0);
    s.covariance = unresolvedSlopes();
    if (hasGusts) s.covariance = roughenedByGusts(s.covariance, s.calm, s.footprint.reach);
    s.slopeStep = s.bounded = 0.0;
    s.compressed = vec2(0.0);
    if (!hasWaves) return;
    vec4 derivatives = vec4(0.0);
    float shear = 0.0;
    vec3 variance = vec3(0.0);
    vec2 place = warped(s.calm);
    [[dont_unroll]] for (int i = 0; i < cascades; ++i) {
        vec3 at = inTile(place, i);
        vec4 d, moments;
        sampleWaves(at, i, s.footprint, d, moments);
        if (hasShore) {
            float kept = s.shore.kept[i];
            d *= kept;
            moments *= vec4(vec3(kept * kept), kept);
        }
        derivatives += d;
        shear += moments.w;
        vec3 lost = moments.xyz - vec3(d.xy * d.xy, d.x * d.y);
        variance += lost;
        if (hasFoam) {
            float counts = water.breakingCounts[i];
            s.compressed += counts * vec2(-dot(water.compression.xyz, vec3(d.zw, moments.w)), counts * max(lost.x + lost.y, 0.0));
        }
        s.bounded += max(lost.x + lost.y, 0.0) * partOfAWave(2.0 * s.footprint.reach * texelsInAMetre(i));
    }
    variance.xy = max(variance.xy, 0.0);
    WaveGradient gradient = waveGradient(derivatives, shear, s.calm);
    if (hasShore) {
        gradient.height += ofShore.height;
        gradient.movedU += ofShore.movedU;
        gradient.movedV += ofShore.movedV;
        float ripples = s.shore.kept[cascades - 1];
        s.covariance *= ripples * ripples;
        variance += unseenOfShore;
    }
    s.slope = slopeOfWaves(gradient);
    s.covariance += variance;
    if (hasShore) s.slope = mix(s.slope, s.shore.bedSlope, onSand(s.shore));
    vec2 change = changeInQuad(s.slope, turn);
    s.slopeStep = max(change.x, change.y);
}

#endif
