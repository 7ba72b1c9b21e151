// What the surface's pixels show: light to the eye, from whichever side it is seen, or what `surfaceOutput` asks for.
#ifndef SURFACE_OUTPUTS_GLSL
#define SURFACE_OUTPUTS_GLSL

#include "surface_shading.glsl"
#include "underwater_light.glsl"
#include "waterline.glsl"
#include "surface_below.glsl"

const uint seenAbove = 0;
const uint seenBelow = 1;

const bool mayBeInWater = hasRefraction && sidesSeen != seenAbove;
const bool mayBeInAir = !hasRefraction || sidesSeen != seenBelow;
const bool mayBeInBoth = mayBeInWater && mayBeInAir;

bool isFromWater(vec2 pixel) {
    return mayBeInWater && (!mayBeInAir || seenFromBelow(pixel));
}

bool isSeenFromWater(const SurfacePoint s) {
    return mayBeInWater && s.fromWater;
}

// Of the facet in the middle of the pixel.
vec3 mirroredDirection(const SurfacePoint s, vec3 normal, vec3 toEye) {
    vec3 direction = reflect(-toEye, normal);
    return isSeenFromWater(s) ? keptBelow(direction) : keptAbove(direction);
}

// Whether any pixel that is shaded with this one is seen from air, and from water: all of them go through the code of both.
struct SidesAround {
    bool air, water;
};

SidesAround sidesAround(const SurfacePoint s) {
    if (!mayBeInBoth) return SidesAround(mayBeInAir, mayBeInWater);
    uint sides = bitsAround(s.fromWater ? 2u : 1u);
    return SidesAround((sides & 1u) != 0u, (sides & 2u) != 0u);
}

// Before Fresnel.
vec3 mirroredRadiance(const SurfacePoint s, vec3 toEye, inout uint turn) {
    SidesAround sides = sidesAround(s);
    vec3 radiance = vec3(0.0);
    if (mayBeInAir && sides.air) {
        Reflection r = reflected(s, toEye, turn);
        radiance = r.radiance / max(r.fresnel, 1e-4);
    }
    if (mayBeInWater && sides.water) {
        vec3 below = mirroredBelow(s, -toEye, turn);
        if (isSeenFromWater(s)) radiance = below;
    }
    return radiance;
}

vec3 radianceFrom(const SurfacePoint s, Foam white, vec3 normal, vec3 toEye, inout uint turn) {
    SidesAround sides = sidesAround(s);
    vec3 radiance = vec3(0.0);
    if (mayBeInAir && sides.air) radiance = shadedAbove(s, white, normal, toEye, turn);
    if (mayBeInWater && sides.water) {
        vec3 below = shadedBelow(s, white.mask, turn);
        if (isSeenFromWater(s)) radiance = below;
    }
    return radiance;
}

vec4 debugOutput(const SurfacePoint s, vec3 normal, vec3 toEye, inout uint turn) {
    if (surfaceOutput == outputHeight) return vec4(s.height, 0.0, 0.0, 1.0);
    if (surfaceOutput == outputNormal) return vec4(inWorld(fromLevel(s, normal)), 1.0);
    if (surfaceOutput == outputSlopes) return vec4(s.slope, s.covariance.xy);
    if (hasFoam && surfaceOutput == outputFoam) return vec4(foamOver(s).mask, 0.0, 0.0, 1.0);
    vec3 mirrored = fromLevel(s, mirroredDirection(s, normal, toEye));
    if (hasReflection && surfaceOutput == outputClass) return vec4(classColor(s, mirrored), 1.0);
    if (hasReflection && surfaceOutput == outputReflectionSource) return reflectionSource(s, mirrored);
    if (surfaceOutput == outputReflectionSource) return vec4(-1.0, -1.0, 0.0, 1.0);   // the sky
    if (surfaceOutput == outputReflection) return vec4(mirroredRadiance(s, toEye, turn), 1.0);
    return vec4(0.0, 0.0, 0.0, 1.0);
}

// Radiance that goes to the eye, or what `surfaceOutput` asks for. Of `s` the sun and the air are found here.
vec4 shaded(SurfacePoint s, inout uint turn) {
    vec3 toEye = toEyeFrom(s);
    vec3 normal = normalOf(s.slope);
    if (surfaceOutput != outputShaded) return debugOutput(s, normal, toEye, turn);
    if (hasSunShadow) s.sunSeen = sunSeenOver(s, toEye);
    return vec4(radianceFrom(s, foamOn(s), normal, toEye, turn), 1.0);
}

// What a kernel does alone, for the rest to take up.
vec4 stepAlone(SurfacePoint s, inout uint turn) {
    vec3 toEye = toEyeFrom(s);
    s.air = airBefore(s.pixel, s.position, s.overPlane);
    if (shadingStep == stepMirror) return min(mirroredAndEntering(s, toEye, turn), vec4(mostOfHalf));
    return heldThrough(throughSurface(s, normalOf(s.slope), toEye, turn));
}

#endif
