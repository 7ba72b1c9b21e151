// Places spray: drops that wind tears off breaking crests. Each cell of water/spray/spray_lattice.h has a particle, which is
// where the air has carried it since the water there broke: how long ago that was, the foam's history says, which fades at a
// known rate. What crest it came from has run on since, and has kept its height.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "one_view.glsl"
#include "body.glsl"
#include "spray_constants.h"
#include "spray_block.h"
#include "foam_fading.h"
#include "optics.glsl"
#include "around_circle.glsl"
#include "in_world.glsl"
#include "wave_maps.glsl"

layout(set = 0, binding = sprayBinding, std140) uniform Spray {
    SprayBlock spray;
};
layout(set = 0, binding = foamHistoryBinding) uniform sampler2DArray foamHistory;

layout(location = 0) out vec2 within;            // of an ellipse, which is the unit circle in it
layout(location = 1) flat out vec4 light;        // radiance, optical depth in the middle
layout(location = 2) flat out vec2 texture_;     // finest wave of it that shows [m], how ragged
layout(location = 3) out vec3 inAir;             // place in the air that blows past [m], downwind less its stretch
layout(location = 4) out float overWaterline;   // height over the water where the line of sight begins [m]

const float densest = 0.03;   // a cloud's optical depth

#include "wave_warp.glsl"
#include "shore.glsl"
#include "wave_displacement.glsl"
#include "foam_gate.glsl"
#include "globe.glsl"
#include "sun_shadow.glsl"
#include "near_plane.glsl"
#include "sky_seen.glsl"
#include "surface_fog.glsl"
#include "hash.glsl"
#include "waterline.glsl"
#include "spray_flight.glsl"

// What the cell of a particle says.
struct Particle {
    uint seed;
    vec2 calm;    // (u, v) of the water that sheds it
    float cell;
    float shown;  // of its level, by distance
};

// Each level fades where the next takes over; parallel lines see all as from one distance.
float shownOf(vec4 place, vec2 calm, int level) {
    float away = distanceForDetail(calm);
    float ends = 1.0 - smoothstep(0.7 * place.w, place.w, away);
    return level == 0 ? ends : ends * smoothstep(0.35 * place.w, 0.5 * place.w, away);
}

Particle particleAt(uint index) {
    int level = 0;
    for (int i = 1; i < sprayLevels; ++i)
        if (index >= uint(spray.cells[i].w)) level = i;
    ivec4 cells = spray.cells[level];
    vec4 place = spray.places[level];
    uint here = index - uint(cells.w);
    uvec2 at = uvec2(here % uint(cells.z), here / uint(cells.z));
    uvec2 cell = uvec2(cells.xy) + at;
    Particle p;
    p.seed = scrambled(scrambled(cell.x + 0x632be5abu * uint(level)) ^ (cell.y * 0x9e3779b9u + 0x85ebca6bu));
    float u = nextShare(p.seed), v = nextShare(p.seed);
    p.calm = place.xy + (vec2(at) + vec2(u, v)) * place.z;
    p.cell = place.z;
    p.shown = shownOf(place, p.calm, level);
    return p;
}

// When water broke.
struct Breaking {
    float ago;    // [s]
    float share;  // that is shown of it; 0: too long ago for drops to be seen
};

// Foam is the product of what each cascade leaves. How long ago water broke, the one says that does most of the breaking: of
// the others' waves several may have passed since, and what none broke wholly looks old. They say how much. `within` is the
// share of a step of the history at which it began.
Breaking breakingAt(vec2 calm, float within) {
    vec2 place = warped(calm);
    float share = foamGate(place, 1.0);
    float ago = 0.0;
    int i = 0;
    do {
        vec3 at = inTile(place, i) - vec3(water.foamDrift[i].xy, 0.0);
        vec2 steps = 1.0 - textureLod(foamHistory, at, 0.0).rg;
        float left = mix(steps.x, steps.y, water.foamStep);
        if (i == int(spray.foam.w)) {
            bool begins = steps.y > steps.x;
            if (begins) left = steps.y;
            float odds = left / (foamOddsScale - left);
            ago = spray.foam.x * log((foamMostOdds + spray.foam.z) / (odds + spray.foam.z));
            ago += (within - (begins ? 1.0 - water.foamStep : 0.0)) * spray.foam.y;
        } else {
            share *= left;
        }
    } while (++i < foamCascades);
    return Breaking(ago, ago < 0.0 || ago >= spray.wind.z ? 0.0 : share);
}

// Irradiance of the sun, and the sky's mean radiance, as drops scatter them to the eye: half forwards by a narrow lobe (Henyey
// and Greenstein), half as a cloud does. Sums to 1 over the sphere, so no cloud is brighter than what lights it.
vec3 scattered(vec3 position) {
    const float g = 0.7;
    vec3 sight = normalize(sightTo(position));
    float d = 1.0 + g * g - 2.0 * g * dot(sight, sunAtEye());
    float turned = (0.4 * (1.0 - g * g) / (d * sqrt(d)) + 0.6) / (4.0 * pi);
    float seen = hasSunShadow ? sunSeenAt(position) : 1.0;
    // The sea below is dark, but for its foam.
    return lightBy(turned * seen, 0.75 / pi);
}

vec3 placeInAir(vec3 at) {
    vec2 downwind = normalize(spray.wind.xy);
    float along = dot(at.xz, downwind) + spray.form.z, across = dot(at.xz, vec2(-downwind.y, downwind.x)) + spray.form.w;
    return vec3(along / sprayAirStretch, across, at.y - calmLevel());
}

void hide() {
    gl_Position = outOfSight;
    within = vec2(0.0);
    light = vec4(0.0);
    texture_ = vec2(0.0);
    inAir = vec3(0.0);
    overWaterline = 0.0;
}

// An eye in the water sees drops beyond the surface as foam on it. The waterline is even over a cloud.
float heightOfSightTo(vec3 at) {
    vec4 pixel = pixelOf(at);
    return heightAboveSurface(pixel.w > 0.0 ? onNearPlane(heldInRegion(pixel.xy)) : vec3(0.0));
}

void main() {
    hide();
    if (isOtherView()) return;
    Particle p = particleAt(uint(gl_VertexIndex) / 3u);
    if (p.shown <= 0.0) return;
    uint draws = p.seed;
    Breaking broke = breakingAt(p.calm, nextShare(draws));
    if (broke.share <= 0.0) return;
    Flight flight = flightOf(draws, broke.ago, spray.wind.xy, spray.wind.w, spray.wind.z);

    vec2 crest = p.calm + spray.wind.w * broke.ago * normalize(spray.wind.xy);
    vec3 position = onCalmPlane(p.calm) + surfaceDisplacement(waveDisplacement, crest, 0.5) + flight.moved;
    vec3 overPlane = position;
    position.y -= globeDrop(position.xz);
    vec4 pixelHere = pixelOf(position);
    if (pixelHere.w <= 0.0) return;

    float radius = max(flight.radius, 0.3 * p.cell);
    vec3 sight = normalize(sightTo(position));
    vec3 streak = flight.velocity - dot(flight.velocity, sight) * sight;
    float speed = length(streak);
    vec3 along = speed > 1e-3 ? streak / speed : normalize(cross(sight, vec3(0.31, 0.9, 0.2)));
    vec3 across = cross(sight, along);
    float pixel = pixelWidth(position);
    float shortHalf = max(radius, 0.7 * pixel);
    // As long as it looks from here.
    float turned = speed / max(length(flight.velocity), 1e-3);
    float longHalf = max(radius * sqrt(1.0 + (flight.stretch * flight.stretch - 1.0) * turned * turned), 0.7 * pixel) + 0.5 * speed * spray.form.y;
    float depth = spray.form.x * broke.share * p.shown * flight.shown * p.cell * p.cell / (pi * shortHalf * longHalf);
    // Of as many drops a denser cloud is drawn as a wider one: others overlap it, and none is told from the veil.
    float wider = clamp(sqrt(depth / densest), 1.0, 4.0);
    shortHalf *= wider;
    longHalf *= wider;
    depth /= wider * wider;
    // What is right before the eye is no cloud any more.
    depth *= smoothstep(1.0, 8.0, distanceTo(position) - radius);
    if (depth <= 1e-3) return;

    vec4 air = airBefore(pixelHere.xy, position, overPlane);
    vec3 radiance = scattered(position);
    light = vec4(hasFog ? mix(air.rgb, radiance, air.a) : radiance, min(depth, 0.35));
    texture_ = vec2(pixel, flight.ragged);
    within = aroundCircle(gl_VertexIndex % 3);
    vec3 at = position + within.x * longHalf * along + within.y * shortHalf * across;
    inAir = placeInAir(at);
    if (straddles) overWaterline = heightOfSightTo(at);
    gl_Position = clipOf(at);
}
