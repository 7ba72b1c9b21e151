// Shades a point of the water's surface that is seen from above: what it mirrors, what shines through, the sun's glint and foam.
#ifndef SURFACE_SHADING_GLSL
#define SURFACE_SHADING_GLSL

#include "tile_quad.glsl"
#include "encoding.glsl"
#include "optics.glsl"
#include "texel_at.glsl"
#include "turns.glsl"
#include "slopes.glsl"
#include "surface_fresnel.glsl"

#include "globe.glsl"
#include "in_world.glsl"
#include "near_plane.glsl"
#include "sky_seen.glsl"
#include "surface_fog.glsl"
#include "footprint.glsl"
#include "surface_point.glsl"
#include "shading_block.glsl"
#include "visible_slopes.glsl"
#include "exclusion_volumes.glsl"
#include "wave_displacement.glsl"
#include "parallax.glsl"
#include "waves_ahead.glsl"
#include "surface_mirror.glsl"
#include "hash.glsl"
#include "glitter.glsl"
#include "sun_glint.glsl"
#include "water_light.glsl"
#include "lit_below.glsl"
#include "refraction.glsl"
#include "subsurface_scattering.glsl"
#include "foam_cover.glsl"

layout(set = 0, binding = shadedBinding, rgba16f) uniform image2D shadedColor;
layout(set = 0, binding = mirroredBinding, rgba16f) uniform image2D mirroredLight;

// Still water shows the sun only where it mirrors the disc. CPU devices look shadows up for all: for the rest at one place, which
// their caches hold.
float sunSeenInDisc(const SurfacePoint s, vec3 toEye) {
    bool isDisc = mirrorsTheDisc(s, toEye);
    if (!isDisc && !quadsInStep) return 1.0;
    float seen = sunSeenAt(isDisc ? s.position : vec3(0.0));
    return isDisc ? seen : 1.0;
}

// A mean over the pixel, by as many taps as its waves get.
float sunSeenOver(const SurfacePoint s, vec3 toEye) {
    if (!hasWaves) return sunSeenInDisc(s, toEye);
    vec2 part = partOf(s.footprint);
    int parts = partsOfPixel();
    float sum = 0.0;
    int i = 0;
    do {
        vec2 aside = part * partsAside(i);
        sum += sunSeenAt(s.position + vec3(aside.x, 0.0, aside.y));
    } while (++i < parts);
    return sum / float(parts);
}

// The mean over the quad where the pixel shows the bed blurred.
Through throughSurface(const SurfacePoint s, vec3 normal, vec3 toEye, inout uint turn) {
    Through through = refracted(s, normal, toEye);
    if (hasRefraction && hasWaves)
        through.radiance = meanFound(vec4(through.radiance, 1.0), s.quadIsAlike ? smoothstep(1.0, 3.0, through.blurred / sharpBed) : 0.0, turn).rgb;
    return through;
}

// As a kernel before left it, where the surface's colour will be. A half holds the way through all water that is not endless.
vec4 heldThrough(Through through) {
    return min(vec4(through.radiance, through.path), vec4(mostOfHalf));
}

Through throughBefore(const SurfacePoint s) {
    vec4 held = imageLoad(shadedColor, ivec2(s.pixel));
    return Through(held.rgb, held.a, 0.0);
}

// Where what a pixel mirrors is left for the rest: where one of several is shaded, in the colour of the one beside it, which is completed
// when that is over.
ivec2 besideInBlock(ivec2 pixel) {
    return ivec2(pixel.x ^ 1, pixel.y);
}

vec4 mirroredBefore(ivec2 pixel) {
    if (!allAreShaded()) return imageLoad(shadedColor, besideInBlock(pixel));
    return imageLoad(mirroredLight, pixel);
}

void keepMirrored(ivec2 pixel, vec4 mirrored) {
    if (!allAreShaded()) imageStore(shadedColor, besideInBlock(pixel), mirrored);
    else imageStore(mirroredLight, pixel, mirrored);
}

// What the surface mirrors, and the share of light that enters the water.
vec4 mirroredAndEntering(const SurfacePoint s, vec3 toEye, inout uint turn) {
    Reflection mirror = reflected(s, toEye, turn);
    return vec4(mirror.radiance, 1.0 - mirror.fresnel + mirror.swallowed);
}

// What the surface itself sends, with `white` on it, and the share of what comes from below that is seen.
vec4 lightOfSurface(const SurfacePoint s, Foam white, vec3 toEye, inout uint turn) {
    vec4 mirror;
    if (shadingStep == stepRest && hasReflection && hasWaves) mirror = mirroredBefore(ivec2(s.pixel));
    else mirror = mirroredAndEntering(s, toEye, turn);
    vec2 glints = sunGlints(s, white, toEye);
    float glint = glints.x;
    WavesAhead ahead = WavesAhead(noWave, 0.0, 0.0, 0.0);
    if (hasWaves) {
        bool isSunlit = s.sunSeen > 0.0 && sunShines();
        if (!wavesAreLookedFor() || isSunlit && (glint > 1e-5 || white.mask > 1e-3)) ahead = wavesBeforeTheSun(s);
        vec3 toSun = sunDirection(s);
        glint *= sunClear(toSun, slopeOf(toEye + toSun), ahead);
    }
    vec4 light = vec4(mirror.rgb + throughAir(sunLight(glint), s.air), mirror.a);
    if (hasFoam) {
        FoamLight foam = foamLight(white, s, toEye, mirror.rgb, ahead, glints.y);
        float plume = lightEnters() ? white.plume : 0.0;   // it shines between the rafts, where water lets light in
        light.rgb += mirror.a * throughAir(plumeGlow(sunDirection(s), s.sunSeen, plume), s.air);
        light = foam.bare * light + vec4(foam.radiance, 0.0);
    }
    return light + vec4(fogLight(s.air), 0.0);
}

// Radiance, with `white` on it. What the surface sends comes first: of what that takes little is alive behind it.
vec3 shadedAbove(SurfacePoint s, Foam white, vec3 normal, vec3 toEye, inout uint turn) {
    s.air = airBefore(s.pixel, s.position, s.overPlane);
    vec4 light = lightOfSurface(s, white, toEye, turn);
    Through through;
    if (shadingStep == stepRest && hasRefraction) through = throughBefore(s);
    else through = throughSurface(s, normal, toEye, turn);
    vec3 below = through.radiance;
    if (hasSubsurfaceScattering) below = throughScattering(below, s, toEye, through.path, white.plume);
    vec3 radiance = light.rgb + light.a * below;
    if (hasShore && hasRefraction) {
        // Wet sand dries, and water thins out into it.
        vec3 dry = sceneAround(s.pixel);
        radiance = mix(dry, radiance, presence(s.shore));
    }
    return radiance;
}

// In the axes of what is level at the point.
vec3 toEyeFrom(const SurfacePoint s) {
    vec3 toEye = -normalize(sightTo(s.position));
    return onGlobe ? toEye * s.level : toEye;
}

Foam foamOn(const SurfacePoint s) {
    return hasFoam ? foamOver(s) : Foam(0.0, 0.0, vec2(0.0), 0.0, 0.0);
}

#endif
