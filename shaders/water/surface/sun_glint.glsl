// Covariance of the slopes whose facets mirror or refract the sun's disc to an eye: `halfway` is normal to the facet of its
// middle, and `gap` long before it was made unit, so that what moves the sun by an angle tilts the facet by that over the gap,
// and less in the plane of incidence by the sun's cosine.
#ifndef SUN_GLINT_GLSL
#define SUN_GLINT_GLSL

#include "surface_point.glsl"
#include "optics.glsl"
#include "waves_ahead.glsl"
#include "visible_slopes.glsl"
#include "surface_fresnel.glsl"
#include "glitter.glsl"

vec3 discOfSlopes(vec3 toSun, vec3 halfway, float gap) {
    const float discVariance = 5.4e-6;   // of 0.00465 rad, along an axis
    float cosSun = dot(toSun, halfway);
    vec2 inPlane = toSun.xz - cosSun * halfway.xz;
    inPlane /= max(length(inPlane), 1e-6);
    float aside = discVariance / (gap * gap);
    float less = aside * (1.0 - cosSun * cosSun);
    return vec3(aside, aside, 0.0) - less * vec3(inPlane * inPlane, inPlane.x * inPlane.y);
}

// Of the slopes within the pixel and the disc, at the slope that mirrors or refracts the sun's middle.
float sunDensity(const SurfacePoint s, vec3 halfway, float gap) {
    vec3 disc = discOfSlopes(sunDirection(s), halfway, gap);
    vec3 covariance = s.covariance + disc;
    float bounded = min((s.bounded + disc.x + disc.y) / (covariance.x + covariance.y), 1.0);
    return slopeDensity(slopeOf(halfway) - s.slope, covariance, bounded);
}

// Radiance of the sun's mirror image, spread by the slopes within the pixel (Bruneton, Neyret and Holzschuch 2010,
// eq. 14) and by its own disc; as a share of its irradiance, before what waves hide of it. Where it `sparkles`, by glitter.glsl.
float glintOfWaves(const SurfacePoint s, vec3 toEye, bool sparkles) {
    vec3 halfway = toEye + sunDirection(s);
    bool isSeen = sunDirection(s).y > 0.0 && halfway.y > 0.0;
    float gap = length(halfway);
    halfway /= gap;
    float density = sunDensity(s, halfway, gap);
    if (hasGlitter && sparkles && density > 1e-3) density = sunDensity(patchOf(s), halfway, gap);
    float fresnel = mirroredShare(dot(toEye, halfway));
    float up2 = halfway.y * halfway.y;
    float glint = s.sunSeen * fresnel * density / (4.0 * up2 * up2 * visibleArea(visibleSlopes(s, toEye), toEye));
    return isSeen ? glint : 0.0;
}

WavesAhead wavesBeforeTheSun(const SurfacePoint s) {
    vec3 toSun = sunDirection(s);
    return wavesAhead(s, horizontal(toSun), toSun.y / max(length(toSun.xz), 1e-6));
}

// From facets of this slope.
float sunClear(vec3 toSun, vec2 slope, WavesAhead ahead) {
    return clearShare(max(toSun.y, 1e-3), dot(slope, horizontal(toSun)), ahead);
}

// Still water mirrors the disc as it is.
const float squaredRadius = 2.16e-5;   // of 0.00465 rad

bool mirrorsTheDisc(const SurfacePoint s, vec3 toEye) {
    vec3 off = vec3(-toEye.x, toEye.y, -toEye.z) - sunDirection(s);
    return sunDirection(s).y > 0.0 && dot(off, off) <= squaredRadius;
}

// Likewise a share.
float glintOfStillWater(const SurfacePoint s, vec3 toEye) {
    return mirrorsTheDisc(s, toEye) ? s.sunSeen * mirroredShare(toEye.y) / (pi * squaredRadius) : 0.0;
}

float sunGlint(const SurfacePoint s, vec3 toEye, bool sparkles) {
    return hasWaves ? glintOfWaves(s, toEye, sparkles) : glintOfStillWater(s, toEye);
}

#endif
