// Light on its way through the water to an eye in it.
#ifndef UNDERWATER_LIGHT_GLSL
#define UNDERWATER_LIGHT_GLSL

#include "body.glsl"
#include "water_light.glsl"

// What `path` metres of water that begin at `depth` and rise by `rise` a metre scatter into the line of sight. Sources
// fade with depth as light does on its way down: straight down from the surface this is deepWater() (1 - exp(-2 k path)),
// which waterGlow() shows above it.
vec3 scatteredIn(vec3 toSun, float depth, float rise, float path) {
    vec3 k = extinction();
    vec3 x = k * ((1.0 - rise) * path);
    vec3 mean = mix((1.0 - exp(-x)) / max(x, 1e-6), 1.0 - 0.5 * x, lessThan(x, vec3(1e-3)));
    return 2.0 * k * deepWater(toSun) * exp(-k * depth) * path * mean;
}

// To what shows of the opaque scene, or where the line of sight leaves calm water, if that is nearer.
float pathInWater(vec3 view, float depth, float toScene) {
    return view.y > 0.0 ? min(depth / view.y, toScene) : toScene;
}

vec3 throughWater(vec3 toSun, vec3 radiance, float depth, float rise, float path) {
    return radiance * exp(-extinction() * path) + scatteredIn(toSun, depth, rise, path);
}

#endif
