// Shades the water's surface: what it mirrors, what shines through, the sun's glint and foam.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#extension GL_EXT_control_flow_attributes : require
#include "surface.glsl"
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
layout(location = 2) flat in uvec2 edgeRange;
layout(location = 0) out vec4 outColor;

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

// Metres of calm water to the next pixel.
float calmPixelWidth() {
    vec2 stepSize = max(abs(dFdx(meshCalm)), abs(dFdy(meshCalm)));
    return max(stepSize.x, stepSize.y);
}

#include "globe.glsl"

// Of what is level at the pixel. On a globe light is reckoned in these, the sky's too, which is that of each place; the eye,
// the scene and where things are keep the body's axes.
mat3 level = mat3(1.0);

vec3 fromLevel(vec3 direction) {
    return onGlobe ? level * direction : direction;
}

// Of what is level here.
vec3 sunDirection() {
    return onGlobe ? water.toSun.xyz * level : water.toSun.xyz;
}

float heightHere;   // above the calm water [m]
float sunSeen = 1.0;   // share of the sun's light that reaches the surface here

// What the host knows of: the sky cube's directions and normals.
vec3 inWorld(vec3 direction) {
    return tilted ? mat3(water.worldFromBody) * direction : direction;
}

#include "near_plane.glsl"
#include "sky_seen.glsl"
#include "surface_fog.glsl"
#include "footprint.glsl"
#include "surface_point.glsl"
#include "visible_slopes.glsl"
#include "exclusion_volumes.glsl"
#include "wave_displacement.glsl"
#include "parallax.glsl"
#include "waves_ahead.glsl"
#include "surface_mirror.glsl"
#include "sun_glint.glsl"
#include "water_light.glsl"
#include "refraction.glsl"
#include "subsurface_scattering.glsl"
#include "underwater_light.glsl"
#include "waterline.glsl"
#include "surface_below.glsl"
#include "foam_cover.glsl"

// A mean over the pixel, by as many looks as its waves get.
float sunSeenHere() {
    if (!hasWaves) return sunSeenAt(position);
    vec2 part = footprintOf(dFdx(meshCalm), dFdy(meshCalm)).longer / float(slopeSamples);
    float sum = 0.0;
    int i = 0;
    do {
        vec2 aside = part * (float(i) + 0.5 - 0.5 * float(slopeSamples));
        sum += sunSeenAt(position + vec3(aside.x, 0.0, aside.y));
    } while (++i < slopeSamples);
    return sum / float(slopeSamples);
}

const bool mayBeInWater = hasRefraction && sidesSeen != seenAbove;
bool showsUnderside = false;

bool isSeenFromWater() {
    return mayBeInWater && showsUnderside;
}

// Of the facet in the middle of the pixel.
vec3 mirroredDirection(vec3 normal, vec3 toEye) {
    vec3 direction = reflect(-toEye, normal);
    return isSeenFromWater() ? keptBelow(direction) : keptAbove(direction);
}

// Before Fresnel.
vec3 mirroredRadiance(SurfacePoint s, vec3 toEye) {
    if (isSeenFromWater()) return mirroredBelow(s, -toEye);
    Reflection r = reflected(s, toEye);
    return r.radiance / max(r.fresnel, 1e-4);
}

vec4 debugOutput(SurfacePoint s, vec3 normal, vec3 toEye) {
    if (surfaceOutput == outputHeight) return vec4(heightHere, 0.0, 0.0, 1.0);
    if (surfaceOutput == outputNormal) return vec4(inWorld(fromLevel(normal)), 1.0);
    if (surfaceOutput == outputSlopes) return vec4(s.slope, s.covariance.xy);
    if (hasFoam && surfaceOutput == outputFoam) return vec4(foamHere().mask, 0.0, 0.0, 1.0);
    vec3 mirrored = fromLevel(mirroredDirection(normal, toEye));
    if (hasReflection && surfaceOutput == outputClass) return vec4(classColor(position, mirrored), 1.0);
    if (hasReflection && surfaceOutput == outputReflectionSource) return reflectionSource(position, mirrored);
    if (surfaceOutput == outputReflectionSource) return vec4(-1.0, -1.0, 0.0, 1.0);   // the sky
    if (surfaceOutput == outputReflection) return vec4(heldOf(mirroredRadiance(s, toEye), targetIsEncoded), 1.0);
    return vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
    loadFog();
    heightHere = meshPosition.y + water.plane.w;
    position = vec3(meshPosition.x, meshPosition.y - globeDrop(meshCalm), meshPosition.z);
    if (mayBeInWater) showsUnderside = sidesSeen == seenBelow || seenFromBelow();
    // Of millions of pixels lavapipe gives the odd one to a triangle without area, with NaN for a depth.
    bool shows = gl_FragCoord.z > 0.0 && gl_FragCoord.z < 1.0 && !isExcluded(position);
    if (isOutlined) shows = shows && isWithin(meshCalm, edgeRange);
    if (hasWaves) quadIsAlike = abs(meanOfQuad(vec4(shows ? (isSeenFromWater() ? -1.0 : 1.0) : 0.0)).x) == 1.0;
    if (!shows) demote;   // `discard` would leave derivatives from here on undefined
    pixelLength = calmPixelWidth();
    if (hasShore) shoreHere = shoreWave(meshCalm, pixelLength);
    calmPosition = shownCalm();
    seesBed = !isSeenFromWater();
    SurfacePoint s = surfacePoint();
    vec3 toEye = -normalize(sightTo(position));
    if (onGlobe) {
        level = levelAt(meshCalm);
        toEye = toEye * level;
    }
    vec3 normal = normalOf(s.slope);
    if (surfaceOutput != outputShaded) {
        outColor = debugOutput(s, normal, toEye);
        return;
    }
    if (hasSunShadow) sunSeen = sunSeenHere();
    Foam white = Foam(0.0, vec2(0.0), 0.0);
    if (hasFoam) white = foamHere();
    if (isSeenFromWater()) {
        outColor = vec4(heldOf(shadedBelow(s, white.mask), targetIsEncoded), 1.0);
        return;
    }
    findAirBefore();
    Reflection mirror = reflected(s, toEye);
    float entering = 1.0 - mirror.fresnel + mirror.swallowed;
    float path;
    float blurred;
    vec3 through = refracted(s, normal, toEye, path, blurred);
    if (hasRefraction && hasWaves)
        through = meanFound(vec4(through, 1.0), quadIsAlike ? smoothstep(1.0, 3.0, blurred / sharpBed) : 0.0).rgb;
    if (hasSubsurfaceScattering) through = throughScattering(through, s, toEye, path);
    vec3 radiance = mirror.radiance + entering * through;
    float glint = sunGlint(s, toEye);
    WavesAhead ahead = WavesAhead(noWave, 0.0, 0.0, 0.0);
    if (hasWaves) {
        bool sunShines = sunSeen * dot(water.sunIrradiance.rgb, vec3(1.0)) > 0.0;
        if (sunShines && (glint > 1e-5 || white.mask > 1e-3)) ahead = wavesBeforeTheSun(s);
        glint *= sunClear(slopeOf(toEye + sunDirection()), ahead);
    }
    radiance += water.sunIrradiance.rgb * glint;
    if (hasFoam) radiance = withFoam(radiance, white, s, toEye, mirror.radiance, ahead);
    if (hasFog) radiance = fogged(radiance, (1.0 - white.mask) * (mirror.sceneOverFog + entering * bedOverFog));
    if (hasShore && hasRefraction) {
        // Wet sand dries, and water thins out into it.
        vec3 dry = linearOf(texelFetch(sceneColor, ivec2(gl_FragCoord.xy + water.sceneShift), 0).rgb, sceneIsEncoded);
        radiance = mix(dry, radiance, presence());
    }
    outColor = vec4(heldOf(radiance, targetIsEncoded), 1.0);
}
