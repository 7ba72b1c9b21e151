// Places what drifts in the water around the eye: its places are a function of the lattice's cells and the time alone.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "one_view.glsl"
#include "body.glsl"
#include "optics.glsl"
#include "around_circle.glsl"
#include "turns.glsl"
#include "hash.glsl"
#include "water_light.glsl"
#include "underwater_light.glsl"

layout(location = 0) out vec2 within;       // of a circle, which is the unit one in it
layout(location = 1) flat out vec4 light;   // radiance, how much it hides in the middle
layout(location = 2) flat out vec3 behind;   // radiance of endless water, for encoded targets

struct Particle {
    vec3 at;
    float radius;   // [m]
    float shown;    // by distance, and where there are so many
};

// Round its place each is carried as waves carry water.
Particle particleAt(uint index) {
    const uint across = uint(snowCellsAcross);
    uint size = index / (across * across * across);
    uvec3 cell = uvec3(index, index / across, index / (across * across)) % across;
    ivec4 first = water.snowCells[size];
    vec4 corner = water.snowPlaces[size];
    uvec3 c = uvec3(first.xyz) + cell;
    uint bits = scrambled(scrambled(scrambled(c.x + 0x632be5abu * size) ^ (c.y * 0x9e3779b9u)) ^ (c.z * 0x85ebca6bu));
    float there = nextShare(bits);
    vec3 place = vec3(nextShare(bits), nextShare(bits), nextShare(bits));
    vec2 turned = cosineSine(water.snow.y + nextShare(bits));
    vec2 sways = vec2(nextShare(bits), nextShare(bits)) - 0.5;
    Particle p;
    p.at = corner.xyz + (vec3(cell) + place) * corner.w + 0.05 * vec3(turned.x * sways, turned.y * sways.x).xzy;
    p.radius = 1e-3 * exp2(float(size)) * (0.4 + 0.8 * nextShare(bits));
    float reach = corner.w * float(snowCellsAcross / 2 - 1);
    float away = length(p.at);
    p.shown = there < water.snow.x ? (1.0 - smoothstep(0.6 * reach, reach, away)) * smoothstep(0.15, 0.4, away) : 0.0;
    // Between crests and troughs it might hang in the air.
    p.shown *= smoothstep(heightDeviation(), 0.05 + 2.0 * heightDeviation(), -heightOverCalm(p.at));
    return p;
}

// What light reaches it there, white that it is.
vec3 radianceAt(float depth) {
    vec3 k = extinction() * depth;
    vec3 arriving = sunEntering(sunAtEye()) * exp(-k) + skyEntering() * exp(-1.2 * k);
    return 0.5 / pi * arriving;
}

void main() {
    gl_Position = outOfSight;
    within = vec2(0.0);
    light = vec4(0.0);
    behind = vec3(0.0);
    if (isOtherView()) return;
    Particle p = particleAt(uint(gl_VertexIndex) / 3u);
    vec4 pixel = pixelOf(p.at);
    if (p.shown <= 0.0 || pixel.w <= 0.0) return;
    float least = 0.7 * pixelWidth(p.at);
    float radius = max(p.radius, least);
    float hides = p.shown * p.radius * p.radius / (radius * radius);
    if (hides < 1e-3) return;
    vec3 view = normalize(p.at);
    vec3 radiance = radianceAt(-heightOverCalm(p.at));
    float depth = max(calmLevel(), 0.0);
    light = vec4(throughWater(sunAtEye(), radiance, depth, view.y, length(p.at)), hides);
    if (targetIsEncoded) behind = scatteredIn(sunAtEye(), depth, view.y, pathInWater(view, depth, 1e6));
    vec3 right = normalize(cross(view, abs(view.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    within = aroundCircle(gl_VertexIndex % 3);
    gl_Position = clipOf(p.at + radius * (within.x * right + within.y * cross(right, view)));
}
