// The columns' transforms along the rows, and from them the maps: displacement, derivatives and moments of
// seaglass/sea.h.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "fft.glsl"
#include "wave_fields.glsl"

layout(set = 0, binding = 1, std430) readonly buffer Columns {
    vec2 columns[];
};
#ifdef COPIED
// To be copied to the images, cascade after cascade.
layout(set = 0, binding = 2, std430) writeonly buffer DisplacementMap {
    vec4 displacementMap[];
};
layout(set = 0, binding = 3, std430) writeonly buffer DerivativeMap {
    vec4 derivativeMap[];
};
layout(set = 0, binding = 4, std430) writeonly buffer MomentMap {
    vec4 momentMap[];
};
#else
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2DArray displacementMap;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2DArray derivativeMap;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2DArray momentMap;
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

void main() {
    uint line = gl_LocalInvocationID.x / team;
    uint place = gl_LocalInvocationID.x % team;
    uint row = gl_WorkGroupID.x * lines + line;
    bool held = row < samples;
    row = min(row, samples - 1u);
    Cascade cascade = cascades[gl_WorkGroupID.y];
    float s = cascade.packing;

    // Column m of the points 0 to 3, and -m of the points 12 to 15.
    uint m[16];
    float ku[16];
#define AHEAD(r) m[r] = place + team * uint(r); ku[r] = cascade.dk * float(m[r]);
#define BEHIND(r) m[r] = team * (16u - uint(r)) - place; ku[r] = cascade.dk * float(m[r]);
#define AHEADS(F) F(0) F(1) F(2) F(3)
#define BEHINDS(F) F(12) F(13) F(14) F(15)
    AHEADS(AHEAD) BEHINDS(BEHIND)

#define COLUMN(field, r)                                                                                               \
    (m[r] < cascade.columns ? columns[columnPoint(cascade.firstColumn + m[r], field, row)] : vec2(0.0))
#define PAIR(x, ahead, behind)                                                                                         \
    vec2 x[16];                                                                                                        \
    {                                                                                                                  \
        AHEADS(ahead)                                                                                                  \
        BEHINDS(behind)                                                                                                \
        fourier16OfEnds(x);                                                                                            \
        finishLine(x, line, place);                                                                                    \
    }
    // Dx + i s dDx/du, from d h.
#define X_AHEAD(r) shiftU[r] = (ku[r] * (1.0 - s * ku[r])) * timesI(COLUMN(1u, r));
#define X_BEHIND(r) shiftU[r] = (-ku[r] * (1.0 + s * ku[r])) * timesI(conjugate(COLUMN(1u, r)));
    PAIR(shiftU, X_AHEAD, X_BEHIND)
    // h + i s dh/du, from h.
#define H_AHEAD(r) height[r] = (1.0 - s * ku[r]) * COLUMN(0u, r);
#define H_BEHIND(r) height[r] = (1.0 + s * ku[r]) * conjugate(COLUMN(0u, r));
    PAIR(height, H_AHEAD, H_BEHIND)
    // Dz + i s dDx/dv, from kv d h.
#define Z_AHEAD(r) shiftV[r] = (1.0 - s * ku[r]) * timesI(COLUMN(2u, r));
#define Z_BEHIND(r) shiftV[r] = (-1.0 - s * ku[r]) * timesI(conjugate(COLUMN(2u, r)));
    PAIR(shiftV, Z_AHEAD, Z_BEHIND)
    // dh/dv + i dDz/dv, from kv (1 -+ kv d) h.
#define V_AHEAD(r) slopeV[r] = timesI(COLUMN(3u, r));
#define V_BEHIND(r) slopeV[r] = -timesI(conjugate(COLUMN(4u, r)));
    PAIR(slopeV, V_AHEAD, V_BEHIND)

    if (!held) return;
    float unpack = 1.0 / s;   // exact
#define STORE(r)                                                                                                       \
    {                                                                                                                  \
        vec2 slope = vec2(height[r].y * unpack, slopeV[r].x);                                                          \
        vec2 stretch = vec2(shiftU[r].y * unpack, slopeV[r].y);                                                        \
        float shear = shiftV[r].y * unpack;                                                                            \
        storeTexel(uvec3(place + team * uint(r), row, gl_WorkGroupID.y),                                               \
                   vec4(shiftU[r].x, height[r].x, shiftV[r].x, shear), vec4(slope, stretch),                           \
                   vec4(slope * slope, slope.x * slope.y, shear));                                                     \
    }
    EACH(STORE)
}
