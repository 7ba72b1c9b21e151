// Light in the water. The irradiance reflectance of deep water is 0.33 bb/a (Morel and
// Prieur 1977).
#ifndef WATER_LIGHT_GLSL
#define WATER_LIGHT_GLSL

#include "body.glsl"
#include "optics.glsl"

vec3 backscatter() {
    return water.backscatter.rgb;
}

vec3 extinction() {
    return max(water.absorption.rgb, 1e-5) + backscatter();
}

// To the side, where light through crests is seen [1/m].
float scatteredByParticles() {
    return water.absorption.w;
}

// Of a body without refraction the water is nothing that light could enter.
bool lightEnters() {
    return water.absorption.r > 0.0;
}

const float skyEnters = 0.934;   // 1 - 0.066, diffuse Fresnel reflectance of water

// Irradiance just below the surface.
vec3 sunEntering(vec3 toSun) {
    if (!onGlobe) return sunLight(water.sunIrradiance.a);
    float up = max(toSun.y, 0.0);
    return sunLight(up * (1.0 - fresnelWater(up)));
}

vec3 skyEntering() {
    return skyLight() * skyEnters;
}

vec3 lightEntering(vec3 toSun) {
    return sunEntering(toSun) + skyEntering();
}

// Radiance of endless water below, seen from just under its surface.
vec3 deepWater(vec3 toSun) {
    return lightEntering(toSun) / pi * (0.33 * backscatter() / extinction());
}

// What endless water sends back, as seen above the surface: leaving water thins radiance by n^2 and what Fresnel keeps.
vec3 endlessGlow(vec3 toSun) {
    const float leaves = 0.98 / (waterIndex * waterIndex);
    return deepWater(toSun) * leaves;
}

// Likewise `path` metres of water.
vec3 waterGlow(vec3 toSun, vec3 path) {
    // Light goes down about as far as it comes back.
    return endlessGlow(toSun) * (1.0 - exp(-2.0 * extinction() * path));
}

#endif
