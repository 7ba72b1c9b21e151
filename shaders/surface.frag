// Shades the water's surface: what it mirrors, what shines through, the sun's glint and foam.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#extension GL_EXT_control_flow_attributes : require
#include "surface.glsl"
#define SCENE_ENCODING 17
#define TARGET_ENCODING 18
#include "encoding.glsl"
#include "optics.glsl"
#include "texel_at.glsl"
#include "turns.glsl"
#include "slopes.glsl"
#include "surface_fresnel.glsl"

layout(location = 0) in vec2 meshCalm;   // (u, v) before displacement, as the mesh has it
vec2 calmPosition;                      // of what the pixel shows
float pixelLength;                      // to the next pixel [m of calm water]
layout(location = 1) in vec3 meshPosition;   // likewise, and before it sinks on a globe
vec3 position;
#ifdef OUTLINE
layout(location = 2) flat in uvec2 edgeRange;
#endif
layout(location = 0) out vec4 outColor;

layout(constant_id = 0) const uint surfaceOutput = 0;
const uint outputShaded = 0;
const uint outputReflection = 1;
const uint outputClass = 2;
const uint outputHeight = 3;
const uint outputNormal = 4;
const uint outputFoam = 5;
const uint outputReflectionSource = 6;
const uint outputSlopes = 7;

layout(constant_id = 1) const uint sidesSeen = 0;   // water/surface.h: SidesSeen
const uint seenAbove = 0;
const uint seenBelow = 1;

// Metres of calm water to the next pixel.
float calmPixelWidth() {
    vec2 stepSize = max(abs(dFdx(meshCalm)), abs(dFdy(meshCalm)));
    return max(stepSize.x, stepSize.y);
}

layout(constant_id = 4) const bool lightsCrests = false;
layout(constant_id = 5) const uint dryRooms = 0;   // water/dry_rooms.h: roomsPacked()
layout(constant_id = 10) const bool tilted = false;
#include "globe.glsl"

// Of what is level at the pixel. On a globe light is reckoned in these, the sky's too, which is that of each place; the eye,
// the scene and where things are keep the body's axes.
mat3 level = mat3(1.0);

vec3 fromLevel(vec3 direction) {
    return onGlobe ? level * direction : direction;
}

float heightHere;   // above the calm water [m]

// What the host knows of: the sky cube's directions and normals.
vec3 inWorld(vec3 direction) {
    return tilted ? worldFromBody * direction : direction;
}

#include "near_plane.glsl"
#include "sky_seen.glsl"
#include "surface_fog.glsl"
#include "footprint.glsl"
#include "surface_point.glsl"
#include "visible_slopes.glsl"
#include "dry_rooms.glsl"
#ifdef WAVES
#include "wave_displacement.glsl"
#endif
#include "relief.glsl"
#include "waves_ahead.glsl"
#include "surface_mirror.glsl"
#include "sun_glint.glsl"
#include "water_light.glsl"
#include "refraction.glsl"
#ifdef WAVES
#include "crest_light.glsl"
#endif
#ifdef REFRACTION
#include "underwater_light.glsl"
#include "waterline.glsl"
#include "surface_below.glsl"
#endif
#ifdef FOAM
#include "foam_cover.glsl"
#endif

#ifdef SUN_SHADOW
// A mean over the pixel, by as many looks as its waves get.
float sunSeenHere() {
#ifdef WAVES
    vec2 part = footprintOf(dFdx(meshCalm), dFdy(meshCalm)).longer / float(slopeLooks);
    float sum = 0.0;
    int i = 0;
    do {
        vec2 aside = part * (float(i) + 0.5 - 0.5 * float(slopeLooks));
        sum += sunSeenAt(position + vec3(aside.x, 0.0, aside.y));
    } while (++i < slopeLooks);
    return sum / float(slopeLooks);
#else
    return sunSeenAt(position);
#endif
}
#endif

bool isSeenFromWater = false;

void findSideSeen() {
#ifdef REFRACTION
    isSeenFromWater = sidesSeen == seenBelow || (sidesSeen != seenAbove && seenFromBelow());
#endif
}

// Of the facet in the middle of the pixel.
vec3 mirroredDirection(vec3 normal, vec3 toEye) {
    vec3 direction = reflect(-toEye, normal);
#ifdef REFRACTION
    if (isSeenFromWater) return keptBelow(direction);
#endif
    return keptAbove(direction);
}

// Before Fresnel.
vec3 mirroredRadiance(SurfacePoint s, vec3 toEye) {
#ifdef REFRACTION
    if (isSeenFromWater) return mirroredBelow(s, -toEye);
#endif
    Reflection r = reflected(s, toEye);
    return r.radiance / max(r.fresnel, 1e-4);
}

vec4 debugOutput(SurfacePoint s, vec3 normal, vec3 toEye) {
    if (surfaceOutput == outputHeight) return vec4(heightHere, 0.0, 0.0, 1.0);
    if (surfaceOutput == outputNormal) return vec4(inWorld(fromLevel(normal)), 1.0);
    if (surfaceOutput == outputSlopes) return vec4(s.slope, s.covariance.xy);
#ifdef FOAM
    if (surfaceOutput == outputFoam) return vec4(foamHere().mask, 0.0, 0.0, 1.0);
#endif
#ifdef REFLECTION
    if (surfaceOutput == outputClass) return vec4(classColor(position, fromLevel(mirroredDirection(normal, toEye))), 1.0);
#endif
    if (surfaceOutput == outputReflectionSource) {
#ifdef REFLECTION
        return reflectionSource(position, fromLevel(mirroredDirection(normal, toEye)));
#else
        return vec4(-1.0, -1.0, 0.0, 1.0);   // the sky
#endif
    }
    if (surfaceOutput == outputReflection) return vec4(heldOf(mirroredRadiance(s, toEye)), 1.0);
    return vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
    loadSurface();
    loadFog();
    heightHere = meshPosition.y + plane.w;
    position = vec3(meshPosition.x, meshPosition.y - globeDrop(meshCalm), meshPosition.z);
    findSideSeen();
    // Of millions of pixels lavapipe gives the odd one to a triangle without area, with NaN for a depth.
    bool shows = gl_FragCoord.z > 0.0 && gl_FragCoord.z < 1.0 && !isDry(position);
#ifdef OUTLINE
    shows = shows && isWithin(meshCalm, edgeRange);
#endif
#ifdef WAVES
    float side = isSeenFromWater ? -1.0 : 1.0;
    quadIsAlike = abs(meanOfQuad(vec4(shows ? side : 0.0)).x) == 1.0;
#endif
    if (!shows) demote;   // `discard` would leave derivatives from here on undefined
    pixelLength = calmPixelWidth();
#ifdef SHORE
    shoreHere = shoreWave(meshCalm, pixelLength);
#endif
    calmPosition = shownCalm();
#ifdef REFRACTION
    looksAtBed = hasBed && !isSeenFromWater;
#endif
    SurfacePoint s = surfacePoint();
    vec3 toEye = -normalize(sightTo(position));
    if (onGlobe) {
        level = levelAt(meshCalm);
        toEye = toEye * level;
        toSun.xyz = toSun.xyz * level;
    }
    vec3 normal = normalOf(s.slope);
    if (surfaceOutput != outputShaded) {
        outColor = debugOutput(s, normal, toEye);
        return;
    }
#ifdef SUN_SHADOW
    sunSeen = sunSeenHere();
#endif
    float foamShare = 0.0;
#ifdef FOAM
    Foam white = foamHere();
    foamShare = white.mask;
#endif
#ifdef REFRACTION
    if (isSeenFromWater) {
        outColor = vec4(heldOf(shadedBelow(s, foamShare)), 1.0);
        return;
    }
#endif
    findAirBefore();
    Reflection mirror = reflected(s, toEye);
    float entering = 1.0 - mirror.fresnel + mirror.swallowed;
    float path;
    float blurred;
    vec3 through = refracted(s, normal, toEye, path, blurred);
#if defined(REFRACTION) && defined(WAVES)
    through = meanFound(vec4(through, 1.0), quadIsAlike ? smoothstep(1.0, 3.0, blurred / sharpBed) : 0.0).rgb;
#endif
#ifdef WAVES
    through = throughCrest(through, s, toEye, path);
#endif
    vec3 radiance = mirror.radiance + entering * through;
    float glint = sunGlint(s, toEye);
#ifdef WAVES
    WavesAhead ahead = WavesAhead(noWave, 0.0, 0.0, 0.0);
    bool sunShines = sunSeen * dot(sunIrradiance.rgb, vec3(1.0)) > 0.0;
    if (sunShines && (glint > 1e-5 || foamShare > 1e-3)) ahead = wavesBeforeTheSun(s);
    glint *= sunClear(slopeOf(toEye + toSun.xyz), ahead);
#endif
    radiance += sunIrradiance.rgb * glint;
#ifdef FOAM
    radiance = withFoam(radiance, white, s, toEye, mirror.radiance, ahead);
#endif
    if (hasFog) radiance = fogged(radiance, (1.0 - foamShare) * (mirror.sceneOverFog + entering * bedOverFog));
#if defined(SHORE) && defined(REFRACTION)
    // Wet sand dries, and water thins out into it.
    vec3 dry = linearOf(texelFetch(sceneColor, ivec2(gl_FragCoord.xy + sceneShift), 0).rgb);
    radiance = mix(dry, radiance, presence());
#endif
    outColor = vec4(heldOf(radiance), 1.0);
}
