// The columns' transforms along the rows, and from them the maps: displacement, derivatives and moments of
// seaglass/sea.h.
#version 450
#extension GL_GOOGLE_include_directive : require

#ifndef COPIED
#define GROUPS 2u
#endif
layout(local_size_x_id = 2) in;   // invocations
#include "wave_fields.glsl"

layout(set = 0, binding = columnsBinding, std430) readonly buffer Columns {
    vec2 columns[];
};
#ifdef COPIED
// To be copied to the images, cascade after cascade.
layout(set = 0, binding = displacementMapBinding, std430) writeonly buffer DisplacementMap {
    vec4 displacementMap[];
};
layout(set = 0, binding = derivativeMapBinding, std430) writeonly buffer DerivativeMap {
    vec4 derivativeMap[];
};
layout(set = 0, binding = momentMapBinding, std430) writeonly buffer MomentMap {
    vec4 momentMap[];
};
#else
layout(set = 0, binding = displacementMapBinding, rgba32f) uniform writeonly image2DArray displacementMap;
layout(set = 0, binding = derivativeMapBinding, rgba32f) uniform writeonly image2DArray derivativeMap;
layout(set = 0, binding = momentMapBinding, rgba32f) uniform writeonly image2DArray momentMap;
#endif

void storeTexel(uvec3 texel, vec4 displacement, vec4 derivatives, vec4 moments) {
#ifdef COPIED
    uint at = (texel.z * samples + texel.y) * samples + texel.x;
    displacementMap[at] = displacement;
    derivativeMap[at] = derivatives;
    momentMap[at] = moments;
#else
    imageStore(displacementMap, ivec3(texel), displacement);
    imageStore(derivativeMap, ivec3(texel), derivatives);
    imageStore(momentMap, ivec3(texel), moments);
#endif
}

vec2 conjugate(vec2 z) {
    return vec2(z.x, -z.y);
}

// A line of a band's rows.
struct Row {
    WaveBand band;
    uint row;
    uint slot;    // of the workgroup's lines
    uint place;
};

vec2 column(Row at, uint m, uint field) {
    return m < at.band.columns ? columns[columnPoint(at.band.firstColumn + m, field, at.row)] : vec2(0.0);
}

// One of the complex fields of water/waves/wave_fields.h, s the band's packing:
//   0: Dx + i s dDx/du, from d h         1: Dz + i s dDx/dv, from kv d h
//   2: h + i s dh/du, from h             3: dh/dv + i dDz/dv, from kv (1 -+ kv d) h
void transform(Row at, uint pair, out vec2 x[16]) {
    uint fieldAhead = pair == 0u ? 1u : pair == 1u ? 2u : pair == 2u ? 0u : 3u;
    uint fieldBehind = pair == 3u ? 4u : fieldAhead;
    float s = at.band.packing;
    // Column m of the points 0 to 3, and -m of the points 12 to 15.
#define AHEAD(r)                                                                                                       \
    {                                                                                                                  \
        uint m = at.place + team * uint(r);                                                                            \
        float ku = at.band.dk * float(m);                                                                           \
        float scale = pair == 3u ? 1.0 : (pair == 0u ? ku : 1.0) * (1.0 - s * ku);                                     \
        vec2 z = column(at, m, fieldAhead);                                                                            \
        x[r] = scale * (pair == 2u ? z : timesI(z));                                                                   \
    }
#define BEHIND(r)                                                                                                      \
    {                                                                                                                  \
        uint m = team * (16u - uint(r)) - at.place;                                                                    \
        float ku = at.band.dk * float(m);                                                                           \
        float scale = pair == 3u ? 1.0 : (pair == 0u ? ku : 1.0) * (1.0 + s * ku);                                     \
        vec2 z = conjugate(column(at, m, fieldBehind));                                                                \
        x[r] = scale * (pair == 2u ? z : -timesI(z));                                                                  \
    }
    AHEAD(0) AHEAD(1) AHEAD(2) AHEAD(3) BEHIND(12) BEHIND(13) BEHIND(14) BEHIND(15)
#undef AHEAD
#undef BEHIND
    fourier16OfEnds(x);
    finishLine(x, at.slot, at.place);
}

void storePoint(Row at, uint r, vec2 shiftU, vec2 shiftV, vec2 height, vec2 slopeV) {
    float unpack = 1.0 / at.band.packing;   // exact
    vec2 slope = vec2(height.y * unpack, slopeV.x);
    float shear = shiftV.y * unpack;
    storeTexel(uvec3(at.place + team * r, at.row, gl_WorkGroupID.y), vec4(shiftU.x, height.x, shiftV.x, shear),
               vec4(slope, shiftU.y * unpack, slopeV.y), vec4(slope * slope, slope.x * slope.y, shear));
}

void main() {
    bool second = gl_LocalInvocationID.x >= group;
    uint member = gl_LocalInvocationID.x % group;
    uint line = member / team;
    uint row = gl_WorkGroupID.x * lines + line;
    bool held = row < samples;
    Row at = Row(waves.bands[gl_WorkGroupID.y], min(row, samples - 1u), (second ? lines : 0u) + line, member % team);

#ifdef COPIED
    vec2 shiftU[16], shiftV[16], height[16], slopeV[16];
    transform(at, 0u, shiftU);
    transform(at, 2u, height);
    transform(at, 1u, shiftV);
    transform(at, 3u, slopeV);
    if (!held) return;
#define STORE(r) storePoint(at, uint(r), shiftU[r], shiftV[r], height[r], slopeV[r]);
    EACH(STORE)
#else
    // The first group transforms the pairs 0 and 2, the other 1 and 3. In a loop, since a compiler that sees
    // both transforms at once keeps the turns of one for the other, in twice the registers. Then the first store the
    // points 0 to 7, the others 8 to 15.
    vec2 shift[16], slope[16];
#define CLEAR(r) slope[r] = vec2(0.0);
    EACH(CLEAR)
    for (uint pair = 0u; pair < 4u; pair += 2u) {
        shift = slope;
        transform(at, pair + (second ? 1u : 0u), slope);
    }
#define EIGHT(F) F(0) F(1) F(2) F(3) F(4) F(5) F(6) F(7)
#define GIVE(r)                                                                                                        \
    exchange[invocations * r + gl_LocalInvocationID.x] = second ? shift[r] : shift[r + 8];                                     \
    exchange[invocations * (r + 8) + gl_LocalInvocationID.x] = second ? slope[r] : slope[r + 8];
    barrier();
    EIGHT(GIVE)
    barrier();
    if (!held) return;
    uint other = gl_LocalInvocationID.x ^ group;
#define STORE(r)                                                                                                       \
    {                                                                                                                  \
        vec2 ownShift = second ? shift[r + 8] : shift[r], ownSlope = second ? slope[r + 8] : slope[r];                 \
        vec2 givenShift = exchange[invocations * r + other], givenSlope = exchange[invocations * (r + 8) + other];                     \
        storePoint(at, uint(r) + (second ? 8u : 0u), second ? givenShift : ownShift, second ? ownShift : givenShift,   \
                   second ? givenSlope : ownSlope, second ? ownSlope : givenSlope);                                    \
    }
    EIGHT(STORE)
#endif
}
