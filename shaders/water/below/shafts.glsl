// Shafts of light: what the waves gather of the sun on its way down, and the water scatters to the eye.
#ifndef SHAFTS_GLSL
#define SHAFTS_GLSL

#include "underwater_light.glsl"
#include "body.glsl"
#include "water_light.glsl"
#include "wave_maps.glsl"
#include "wave_warp.glsl"

// Times what calm water lets through, at a depth under the calm place where the sun's ray comes in; a mean over `width` metres.
// What they gather stays between none and twice the mean, as far from it as rays that meet soon do.
float gatheredUnder(vec2 enters, float depth, float width) {
    vec2 place = warped(enters);
    float curvature = 0.0;
    int i = 0, count = waveCascades();
    do {
        float texels = max(width * texelsInAMetre(i), 1.0);
        float mip = log2(texels);
        if (!showsWaves(mip + 1.0)) continue;
        vec3 at = inTile(place, i);
        float perWidth = texelsInAMetre(i) / texels;
        float rise = textureLod(waveDisplacement, at, mip + 1.0).y - textureLod(waveDisplacement, at, mip).y;
        curvature += rise * perWidth * perWidth;
    } while (++i < count);
    // A linear tap of texels of w has a variance of w^2/4 each way, so the next mip is higher by 3/8 w^2 of the curvature.
    float turned = 8.0 / 3.0 * curvature * water.shafts.z * depth;
    return 1.0 - turned * inversesqrt(0.25 + turned * turned);
}

// How many times more than to its side water scatters at an angle to the beam: Henyey and Greenstein's, of particles. Light that
// is turned by a few degrees still counts as the beam, so it is less peaked.
float scatteredAhead(float cosine) {
    const float g = 0.6;
    float share = (1.0 + g * g) / (1.0 + g * g - 2.0 * g * cosine);
    return max(share * sqrt(share), 1.0);
}

// What they add to scatteredIn() of the same line of sight, which has the mean of all directions: what scatters ahead, and by how
// much waves gather it. Each step sees as much of the waves as it is long, so that none is missed; far off that is their mean.
vec3 shaftsIn(vec3 toSun, vec3 start, vec3 view, float depth, float path) {
    const int steps = 20;
    const float farthest = 9.0;   // [m]
    vec3 from = sunInWater();
    vec2 aside = from.xz / from.y;
    vec2 perMetre = view.xz - aside * view.y;   // of where the sun's ray came in
    vec3 k = extinction();
    float ahead = scatteredAhead(dot(view, from));
    float reach = min(path, farthest);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float u = (float(i) + 0.5) / float(steps);
        float way = reach * u * u, step = 2.0 * reach * u / float(steps);
        vec3 at = start + view * way;
        float below = max(depth - view.y * way, 0.0);
        float width = max(step * length(perMetre), below * water.shafts.y);
        float fades = 1.0 - way / farthest;
        sum += step * fades * (gatheredUnder(at.xz + aside * below, below, width) - 1.0) * exp(-k * (below + way));
    }
    vec3 sun = sunEntering(toSun);
    vec3 gathered = ahead * sum * sun / pi * (2.0 * 0.33 * backscatter());
    vec3 halo = (ahead - 1.0) * scatteredIn(toSun, depth, view.y, path) * sun / max(lightEntering(toSun), 1e-9);
    return water.shafts.x * (gathered + halo);
}

#endif
