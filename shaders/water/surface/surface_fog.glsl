// The host's fog in the air before the water, and over the sky that it mirrors.
#ifndef SURFACE_FOG_GLSL
#define SURFACE_FOG_GLSL

#include "in_world.glsl"
#include "body.glsl"
#include "near_plane.glsl"
#include "sky_seen.glsl"
#include "medium.glsl"

const bool hasFog = fogKind != 0;
const int fogShape = int(fogKind & 7u);
const bool fogsSky = (fogKind & 8u) != 0;
const bool fogFromSky = (fogKind & 16u) != 0;

SeaglassFog airFog() {
    return SeaglassFog(water.fogColor, water.fogForm, water.fogReach);
}

// Of a way in the body's axes. On a globe fog lies on the ball: of a point as it was before it sank.
float worldRise(vec3 way) {
    return inWorld(way).y;
}

// `from` as it was before it sank.
vec3 foggedSky(vec3 sky, vec3 from, vec3 direction) {
    if (!hasFog || !fogsSky) return sky;
    return seaglass_foggedSky(fogShape, airFog(), sky, worldRise(from), inWorld(direction));
}

// Blurred alike: 0.04 rad are 0.65 of a texel of that mip.
vec3 skyOfFog(vec3 along) {
    if (skyHasColors) return skyOfColors(along, 0.04);
    return cubeAt(along, seaglass_fogMip(cubeMips()));
}

// Radiance of endless fog before the surface, and what share of light passes the way there. `overPlane` is where it was
// before it sank.
vec4 airBefore(vec2 pixel, vec3 position, vec3 overPlane) {
    if (!hasFog) return vec4(vec3(0.0), 1.0);
    vec3 start = sightIsParallel() ? onNearPlane(pixel) : vec3(0.0);
    float way = length(position - start);
    vec3 color = airFog().color.rgb;
    if (fogFromSky) {
        vec3 along = seaglass_fogSight(inWorld((position - start) / max(way, 1e-6)));
        color = seaglass_fogColor(airFog(), skyOfFog(along));
    }
    return vec4(color, seaglass_transmittance(fogShape, airFog(), worldRise(start), worldRise(overPlane - start), way));
}

// What passes the air of light that the water itself sends; fogLight() comes on top once.
vec3 throughAir(vec3 light, vec4 air) {
    return hasFog ? air.a * light : light;
}

// Likewise of light from the scene, which is that `share` of the scene's. The host has fogged that up to what shows there, which is about
// as far away as the water that shows it. So what it differs by from endless fog passes whole.
vec3 sceneThroughAir(vec3 light, vec3 share, vec4 air) {
    return hasFog ? light - (1.0 - air.a) * share * air.rgb : light;
}

vec3 fogLight(vec4 air) {
    return hasFog ? (1.0 - air.a) * air.rgb : vec3(0.0);
}

#endif
