// What the surface's fragments write: light to the eye, from whichever side it is seen, or what `surfaceOutput` asks for. Needs
// surface_shading.glsl.
#include "underwater_light.glsl"
#include "waterline.glsl"
#include "surface_below.glsl"

const uint outputShaded = 0;
const uint outputReflection = 1;
const uint outputClass = 2;
const uint outputHeight = 3;
const uint outputNormal = 4;
const uint outputFoam = 5;
const uint outputReflectionSource = 6;
const uint outputSlopes = 7;

const uint seenAbove = 0;
const uint seenBelow = 1;

const bool mayBeInWater = hasRefraction && sidesSeen != seenAbove;

bool isSeenFromWater(const SurfacePoint s) {
    return mayBeInWater && s.fromWater;
}

// Of the facet in the middle of the pixel.
vec3 mirroredDirection(const SurfacePoint s, vec3 normal, vec3 toEye) {
    vec3 direction = reflect(-toEye, normal);
    return isSeenFromWater(s) ? keptBelow(direction) : keptAbove(direction);
}

// Before Fresnel.
vec3 mirroredRadiance(const SurfacePoint s, vec3 toEye) {
    if (isSeenFromWater(s)) return mirroredBelow(s, -toEye);
    Reflection r = reflected(s, toEye);
    return r.radiance / max(r.fresnel, 1e-4);
}

vec4 debugOutput(const SurfacePoint s, vec3 normal, vec3 toEye) {
    if (surfaceOutput == outputHeight) return vec4(s.height, 0.0, 0.0, 1.0);
    if (surfaceOutput == outputNormal) return vec4(inWorld(fromLevel(s, normal)), 1.0);
    if (surfaceOutput == outputSlopes) return vec4(s.slope, s.covariance.xy);
    if (hasFoam && surfaceOutput == outputFoam) return vec4(foamOver(s).mask, 0.0, 0.0, 1.0);
    vec3 mirrored = fromLevel(s, mirroredDirection(s, normal, toEye));
    if (hasReflection && surfaceOutput == outputClass) return vec4(classColor(s, mirrored), 1.0);
    if (hasReflection && surfaceOutput == outputReflectionSource) return reflectionSource(s, mirrored);
    if (surfaceOutput == outputReflectionSource) return vec4(-1.0, -1.0, 0.0, 1.0);   // the sky
    if (surfaceOutput == outputReflection) return vec4(heldOf(mirroredRadiance(s, toEye), targetIsEncoded), 1.0);
    return vec4(0.0, 0.0, 0.0, 1.0);
}

// Radiance that goes to the eye, or what `surfaceOutput` asks for. Of `s` the sun and the air are found here.
vec4 shaded(SurfacePoint s) {
    vec3 toEye = toEyeFrom(s);
    vec3 normal = normalOf(s.slope);
    if (surfaceOutput != outputShaded) return debugOutput(s, normal, toEye);
    if (hasSunShadow) s.sunSeen = sunSeenOver(s);
    Foam white = foamOn(s);
    vec3 radiance;
    if (isSeenFromWater(s)) radiance = shadedBelow(s, white.mask);
    else radiance = shadedAbove(s, white, normal, toEye);
    return vec4(heldOf(radiance, targetIsEncoded), 1.0);
}
