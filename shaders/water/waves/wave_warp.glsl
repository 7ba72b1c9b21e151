// How the waves' tiles are drawn out of shape: where maps are looked up for a place (water/interface/warp.h).
#ifndef WAVE_WARP_GLSL
#define WAVE_WARP_GLSL

#include "body.glsl"

struct WarpWaves {
    vec2 turns;   // of both waves, -1/2..1/2
    vec4 along;   // their wave vectors [turns/m]
    float by;     // eight amplitudes [m]
};

WarpWaves warpWavesAt(int scale, vec2 calm) {
    vec4 along = water.warpAlong[scale];
    vec4 from = water.warpFrom[scale];
    vec2 turns = from.xy + vec2(dot(along.xy, calm), dot(along.zw, calm));
    return WarpWaves(turns - round(turns), along, from.z);
}

vec2 shiftBy(WarpWaves waves) {
    return waves.by * waves.turns * (1.0 - 2.0 * abs(waves.turns));
}

// From the eye, as `calm` [m]; water.cascade has what is missing to no shift at the origin.
vec2 warped(vec2 calm) {
    if (!isWarped) return calm;
    return calm + shiftBy(warpWavesAt(0, calm)) + shiftBy(warpWavesAt(1, calm)) + shiftBy(warpWavesAt(2, calm));
}

// Where a warped() place is looked up in a cascade's maps.
vec3 inTile(vec2 place, int cascade) {
    return vec3(water.cascade[cascade].xy + place * water.cascade[cascade].z, cascade);
}

// Whether a mip of the maps holds waves: the last is the tile's mean, which is zero.
bool showsWaves(float mip) {
    return mip < water.maxMip;
}

float tilesInAMetre(int cascade) {
    return water.cascade[cascade].z;
}

float texelsInAMetre(int cascade) {
    return water.cascade[cascade].w;
}

// How the shift along u changes along u and v, and that along v.
vec4 warpGradientAt(int scale, vec2 calm) {
    WarpWaves waves = warpWavesAt(scale, calm);
    return (waves.by * (1.0 - 4.0 * abs(waves.turns))).xxyy * waves.along;
}

// Derivatives along u and v of what is looked up where the shift leads.
vec2 alongWarped(vec2 derivatives, vec4 gradient) {
    return derivatives + derivatives.x * gradient.xy + derivatives.y * gradient.zw;
}

// How waves change along u and v: their height, and where they move a point along u, and along v.
struct WaveGradient {
    vec2 height;
    vec2 movedU, movedV;
};

// Of the waves at a place, by the sums of their maps: dh/du, dh/dv, dDx/du, dDz/dv, and the shear dDx/dv.
WaveGradient waveGradient(vec4 derivatives, float shear, vec2 calm) {
    WaveGradient g = WaveGradient(derivatives.xy, vec2(derivatives.z, shear), vec2(shear, derivatives.w));
    if (!isWarped) return g;
    vec4 warp = warpGradientAt(0, calm) + warpGradientAt(1, calm) + warpGradientAt(2, calm);
    return WaveGradient(alongWarped(g.height, warp), alongWarped(g.movedU, warp), alongWarped(g.movedV, warp));
}

// Of the surface: tangents (1 + dDx/du, dh/du, dDz/du) and (dDx/dv, dh/dv, 1 + dDz/dv), whose cross product is the normal.
// Where the surface folds the Jacobian passes zero and the slope is vertical.
vec2 slopeOfWaves(WaveGradient g) {
    float u = 1.0 + g.movedU.x, v = 1.0 + g.movedV.y;
    vec2 bent = vec2(g.height.x * v - g.height.y * g.movedV.x, g.height.y * u - g.height.x * g.movedU.y);
    return bent / max(u * v - g.movedU.y * g.movedV.x, 0.15);
}

#endif
