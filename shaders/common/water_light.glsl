// Light scattered back by the water itself. The irradiance reflectance of deep water is 0.33 bb/a (Morel and Prieur 1977).

// Irradiance just below the surface.
vec3 lightEntering() {
    float sunEnters = max(toSun.y, 0.0) * (1.0 - fresnelWater(max(toSun.y, 0.0)));
    const float skyEnters = 0.934;   // 1 - 0.066, diffuse Fresnel reflectance of water
    return sunIrradiance.rgb * sunEnters + skyIrradiance.rgb * skyEnters;
}

// Radiance of endless water below, seen from just under its surface.
vec3 deepWater() {
    vec3 a = max(absorption.rgb, 1e-5);
    vec3 reflectance = 0.33 * backscatter.rgb / (a + backscatter.rgb);
    return lightEntering() / pi * reflectance;
}

// What `path` metres of water send back, as seen above the surface: leaving water thins radiance by n^2 and what Fresnel
// keeps.
vec3 waterGlow(vec3 path) {
    vec3 a = max(absorption.rgb, 1e-5);
    const float leaves = 0.98 / (waterIndex * waterIndex);
    // Light goes down about as far as it comes back.
    return deepWater() * leaves * (1.0 - exp(-2.0 * (a + backscatter.rgb) * path));
}
