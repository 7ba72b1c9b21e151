// Inverse Fourier transforms, unnormalised, of lines of `samples` points: Stockham's autosort (Govindaraju et al. 2008)
// in steps of 16, then one of 2, 4 or 8 if there is need. A team of samples / 16 invocations holds a line, 16 points
// each. A workgroup has GROUPS groups of as many teams as fit into 64 invocations, of one team if it is larger.
// Arrays are indexed by literals alone, so that they stay in registers.
#ifndef FFT_GLSL
#define FFT_GLSL

#extension GL_GOOGLE_include_directive : require
#include "phase.glsl"
#include "constant.glsl"
#include "waves_constants.h"

#ifndef GROUPS
#define GROUPS 1u
#endif

const uint team = samples / 16u;
const uint group = invocations / GROUPS;
const uint lines = group / team;   // of a group

shared vec2 exchange[16u * invocations];

vec2 times(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}
vec2 timesI(vec2 a) {
    return vec2(-a.y, a.x);
}

void fourier2(inout vec2 a, inout vec2 b) {
    vec2 difference = a - b;
    a += b;
    b = difference;
}

void fourier4(inout vec2 a, inout vec2 b, inout vec2 c, inout vec2 d) {
    vec2 ac = a + c, acLess = a - c;
    vec2 bd = b + d, bdLess = timesI(b - d);
    a = ac + bd;
    b = acLess + bdLess;
    c = ac - bd;
    d = acLess - bdLess;
}

const float sqrtHalf = 0.70710678118654752;
const vec2 sixteenth = vec2(0.92387953251128674, 0.38268343236508977);

void fourier8(inout vec2 x0, inout vec2 x1, inout vec2 x2, inout vec2 x3, inout vec2 x4, inout vec2 x5, inout vec2 x6,
              inout vec2 x7) {
    fourier4(x0, x2, x4, x6);
    fourier4(x1, x3, x5, x7);
    x3 = sqrtHalf * (x3 + timesI(x3));
    x5 = timesI(x5);
    x7 = sqrtHalf * (timesI(x7) - x7);
    fourier2(x0, x1);
    fourier2(x2, x3);
    fourier2(x4, x5);
    fourier2(x6, x7);
    // Sums are the first half of the line, differences the second.
    vec2 y1 = x2, y2 = x4, y3 = x6, y4 = x1, y5 = x3, y6 = x5;
    x1 = y1;
    x2 = y2;
    x3 = y3;
    x4 = y4;
    x5 = y5;
    x6 = y6;
}

// From sums over every fourth point, x[4 k + n] that of point n's at frequency k, to the whole line.
void finishFourier16(inout vec2 x[16]) {
    x[5] = times(x[5], sixteenth);
    x[6] = sqrtHalf * (x[6] + timesI(x[6]));
    x[7] = times(x[7], sixteenth.yx);
    x[9] = sqrtHalf * (x[9] + timesI(x[9]));
    x[10] = timesI(x[10]);
    x[11] = sqrtHalf * (timesI(x[11]) - x[11]);
    x[13] = times(x[13], sixteenth.yx);
    x[14] = sqrtHalf * (timesI(x[14]) - x[14]);
    x[15] = times(x[15], -sixteenth);
    fourier4(x[0], x[1], x[2], x[3]);
    fourier4(x[4], x[5], x[6], x[7]);
    fourier4(x[8], x[9], x[10], x[11]);
    fourier4(x[12], x[13], x[14], x[15]);
    x = vec2[16](x[0], x[4], x[8], x[12], x[1], x[5], x[9], x[13], x[2], x[6], x[10], x[14], x[3], x[7], x[11], x[15]);
}

void fourier16(inout vec2 x[16]) {
    fourier4(x[0], x[4], x[8], x[12]);
    fourier4(x[1], x[5], x[9], x[13]);
    fourier4(x[2], x[6], x[10], x[14]);
    fourier4(x[3], x[7], x[11], x[15]);
    finishFourier16(x);
}

// The same where x[4] to x[11] are zero.
void fourier16OfEnds(inout vec2 x[16]) {
#define ENDS(n)                                                                                                        \
    {                                                                                                                  \
        vec2 last = x[12 + n];                                                                                         \
        x[12 + n] = x[n] + timesI(last);                                                                               \
        x[8 + n] = x[n] - last;                                                                                        \
        x[4 + n] = x[n] - timesI(last);                                                                                \
        x[n] += last;                                                                                                  \
    }
    ENDS(0)
    ENDS(1)
    ENDS(2)
    ENDS(3)
#undef ENDS
    finishFourier16(x);
}

// x[r] times e^(i r phase).
void turn16(inout vec2 x[16], uint phase) {
    vec2 w1 = cosineSine(phase), w2 = cosineSine(2u * phase), w3 = cosineSine(3u * phase);
    vec2 w4 = cosineSine(4u * phase), w8 = cosineSine(8u * phase), w12 = cosineSine(12u * phase);
    x[1] = times(x[1], w1);
    x[2] = times(x[2], w2);
    x[3] = times(x[3], w3);
    x[4] = times(x[4], w4);
    x[5] = times(x[5], times(w4, w1));
    x[6] = times(x[6], times(w4, w2));
    x[7] = times(x[7], times(w4, w3));
    x[8] = times(x[8], w8);
    x[9] = times(x[9], times(w8, w1));
    x[10] = times(x[10], times(w8, w2));
    x[11] = times(x[11], times(w8, w3));
    x[12] = times(x[12], w12);
    x[13] = times(x[13], times(w12, w1));
    x[14] = times(x[14], times(w12, w2));
    x[15] = times(x[15], times(w12, w3));
}

// Keeps invocations off each other's banks; a CPU device has none.
uint spread(uint point) {
    return onCpu ? point : point ^ (point / 16u % 16u);
}

// Points leave as `first + step r` and come back as `place + team r`, both within the team's line.
void exchangePoints(inout vec2 x[16], uint line, uint first, uint step, uint place) {
    uint start = line * samples;
    barrier();
#define LEAVE(r) exchange[spread(start + first + step * uint(r))] = x[r];
#define RETURN(r) x[r] = exchange[spread(start + place + team * uint(r))];
#define EACH(F) F(0) F(1) F(2) F(3) F(4) F(5) F(6) F(7) F(8) F(9) F(10) F(11) F(12) F(13) F(14) F(15)
    EACH(LEAVE)
    barrier();
    EACH(RETURN)
#undef LEAVE
#undef RETURN
}

const uint sixteenthTurn = 0x10000000u;   // to the next of a team's butterflies

// The last step of 32 or 512 points.
void finishByTwos(inout vec2 x[16], uint turned) {
#define BUTTERFLY(b)                                                                                                   \
    x[b + 8] = times(x[b + 8], cosineSine(turned + uint(b) * sixteenthTurn));                                                    \
    fourier2(x[b], x[b + 8]);
    BUTTERFLY(0)
    BUTTERFLY(1)
    BUTTERFLY(2)
    BUTTERFLY(3)
    BUTTERFLY(4)
    BUTTERFLY(5)
    BUTTERFLY(6)
    BUTTERFLY(7)
#undef BUTTERFLY
}

// What is left of a transform after fourier16 or fourier16OfEnds on the points place + team r, r = 0..15. The result
// lies at the same points.
void finishLine(inout vec2 x[16], uint line, uint place) {
    if (samples == 16u) return;
    exchangePoints(x, line, 16u * place, 1u, place);
    uint turned = place * (0xffffffffu / samples + 1u);
    if (samples > 256u) {
        uint within = place % 16u;
        turn16(x, within * 0x1000000u);
        fourier16(x);
        exchangePoints(x, line, place / 16u * 256u + within, 16u, place);
    }
    if (samples == 256u) {
        turn16(x, turned);
        fourier16(x);
    } else if (samples == 128u || samples == 2048u) {
#define BUTTERFLY(b)                                                                                                   \
    {                                                                                                                  \
        uint phase = turned + uint(b) * sixteenthTurn;                                                                           \
        vec2 w1 = cosineSine(phase), w2 = cosineSine(2u * phase), w4 = cosineSine(4u * phase);                         \
        vec2 w3 = times(w2, w1);                                                                                       \
        x[b + 2] = times(x[b + 2], w1);                                                                                \
        x[b + 4] = times(x[b + 4], w2);                                                                                \
        x[b + 6] = times(x[b + 6], w3);                                                                                \
        x[b + 8] = times(x[b + 8], w4);                                                                                \
        x[b + 10] = times(x[b + 10], times(w4, w1));                                                                   \
        x[b + 12] = times(x[b + 12], times(w4, w2));                                                                   \
        x[b + 14] = times(x[b + 14], times(w4, w3));                                                                   \
        fourier8(x[b], x[b + 2], x[b + 4], x[b + 6], x[b + 8], x[b + 10], x[b + 12], x[b + 14]);                       \
    }
        BUTTERFLY(0)
        BUTTERFLY(1)
#undef BUTTERFLY
    } else if (samples == 64u || samples == 1024u) {
#define BUTTERFLY(b)                                                                                                   \
    {                                                                                                                  \
        uint phase = turned + uint(b) * sixteenthTurn;                                                                           \
        x[b + 4] = times(x[b + 4], cosineSine(phase));                                                                 \
        x[b + 8] = times(x[b + 8], cosineSine(2u * phase));                                                            \
        x[b + 12] = times(x[b + 12], cosineSine(3u * phase));                                                          \
        fourier4(x[b], x[b + 4], x[b + 8], x[b + 12]);                                                                 \
    }
        BUTTERFLY(0)
        BUTTERFLY(1)
        BUTTERFLY(2)
        BUTTERFLY(3)
#undef BUTTERFLY
    } else {
        finishByTwos(x, turned);
    }
}

#endif
