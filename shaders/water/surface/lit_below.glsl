// Light on what lies in the water.
#ifndef LIT_BELOW_GLSL
#define LIT_BELOW_GLSL

#include "water_light.glsl"
#include "encoding.glsl"

// drawCaustics() has multiplied the alpha of a scene's colour too, which was 1. A host that has other things there has no
// caustics there.
float gatheredIn(vec4 color) {
    if (sceneIsEncoded) {
        bool held = water.causticStrength > 0.0 && color.a > 0.01 && color.a < leastUntold;
        return held ? mostGathered * color.a : 1.0;
    }
    bool told = water.causticStrength > 0.0 && color.a > 0.05 && color.a < 20.0;
    return told ? color.a : 1.0;
}

// The host lit the bed as if in air: its radiance at `depth` metres under calm water. The sun comes down along the ray
// that the surface bends, the sky's light within Snell's window, 1.2 m a metre of depth in the mean; what the bed sends
// up too flatly the surface turns back to it, 3 m a metre each way: from all around, and so without what waves have
// `gathered` in that very place, a factor in the host's radiance. How bright a bed is in how much light says how white.
vec3 litBelow(vec3 toSun, vec3 inAir, float depth, float gathered) {
    vec3 k = extinction() * max(depth, 0.0);
    float up = max(toSun.y, 0.0);
    vec3 light = lightBy(up, 1.0);
    float sunSteepness = sqrt(1.0 - (1.0 - up * up) / (waterIndex * waterIndex));
    vec3 arriving = sunEntering(toSun) * exp(-k / sunSteepness) + skyEntering() * exp(-1.2 * k);
    vec3 albedo = min(pi * inAir / max(light * gathered, 1e-9), 1.0);
    const float turnedBack = 1.0 - skyEnters / (waterIndex * waterIndex);
    vec3 again = turnedBack * albedo * exp(-6.0 * k);
    vec3 lit = inAir * arriving / max(light, 1e-9) * (1.0 + again / (1.0 - again) / gathered);
    return mix(lit, inAir, lessThan(light, vec3(1e-6)));   // in no light it shines itself
}

#endif
