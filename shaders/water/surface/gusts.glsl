// Gusts on the water: cat's paws, patches of ripples that run with the wind (Dorman and Mollo-Christensen 1973). They roughen what
// a pixel shows of slopes, and move nothing. A gust is a place of smooth noise that the wind carries along: water/surface/gusts_part.cpp
// says where.
#ifndef GUSTS_GLSL
#define GUSTS_GLSL

#include "body.glsl"
#include "value_noise.glsl"

const float gustyShare = 0.27;   // of the water, in the mean

// Three octaves of mean 1/2, of which those too fine for `width` cells are that.
float gustNoise(ivec4 from, vec2 at, float width) {
    float sum = 0.5, weight = 0.5;
    int scale = 1;
    [[dont_unroll]] for (int i = 0; i < 3; ++i) {
        vec2 whole = floor(float(scale) * at);
        ivec2 cell = scale * from.xy + ivec2(whole);
        float noise = noiseWithin(cell, float(scale) * at - whole, uint(from.z));
        sum += weight * (1.0 - smoothstep(0.5, 2.0, width * float(scale))) * (noise - 0.5);
        weight = i == 0 ? 0.3 : 0.2;
        scale *= 3;
    }
    return sum;
}

// Share of the place, `calm` from the eye [m], that gusts are over, as a mean over `width`.
float gustsAt(vec2 calm, float width) {
    float cells = water.gusts.z;
    float sum = 0.0;
    // One generation comes as the other goes.
    [[dont_unroll]] for (int i = 0; i < 2; ++i) {
        vec4 place = water.gustPlace[i];
        float noise = gustNoise(water.gustCell[i], place.xy + cells * calm, cells * width);
        sum += place.z * smoothstep(0.52, 0.66, noise);
    }
    return mix(sum, gustyShare, smoothstep(0.5, 2.0, cells * width));
}

// Of a covariance that is shorter than the maps' waves. What an open sea has is moved from lulls into gusts, so that its mean stays;
// what shelter took from sheltered water, gusts bring back where they are.
vec3 roughenedByGusts(vec3 covariance, vec2 calm, float width) {
    float gusts = gustsAt(calm, width);
    float strength = water.gusts.x;
    return covariance * (1.0 + strength * (gusts / gustyShare - 1.0)) + strength * gusts * water.gusts.y * vec3(1.0, 1.0, 0.0);
}

#endif
