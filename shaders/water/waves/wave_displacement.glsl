// How far the waves move a point of the calm plane, as a mean over `width` metres.
#ifndef WAVE_DISPLACEMENT_GLSL
#define WAVE_DISPLACEMENT_GLSL

#include "body.glsl"
#include "wave_maps.glsl"
#include "wave_warp.glsl"
#include "shore.glsl"

// `kept` is a share of each cascade.
vec3 waveDisplacementAt(sampler2DArray displacements, vec2 calm, float width, vec4 kept) {
    vec3 sum = vec3(0.0);
    vec2 place = warped(calm);
    int i = 0, count = waveCascades();
    [[dont_unroll]] do {
        float mip = log2(max(width * texelsInAMetre(i), 1.0));
        if (showsWaves(mip))
            sum += kept[i] * textureLod(displacements, inTile(place, i), mip).xyz;
    } while (++i < count);
    return sum;
}

// Over a shore's bed; with the film on its sand.
vec3 displacementOver(ShoreWave shore, sampler2DArray displacements, vec2 calm, float width) {
    vec3 moved = waveDisplacementAt(displacements, calm, width, shore.kept);
    moved += vec3(shore.move.x, shore.height, shore.move.y);
    moved.y = withFilm(shore, moved.y, filmLift + 0.01 * width);
    return moved;
}

// Of the water's surface, wherever there is a bed or none.
vec3 surfaceDisplacement(sampler2DArray displacements, vec2 calm, float width) {
    if (hasShore) return displacementOver(shoreWave(calm, width), displacements, calm, width);
    return waveDisplacementAt(displacements, calm, width, vec4(1.0));
}

#endif
