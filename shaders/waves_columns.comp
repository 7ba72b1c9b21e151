// The waves of this moment, h(k,t) = h0(k) e^(iwt) + conj(h0(-k)) e^(-iwt), and their transforms along the columns of
// ku >= 0. A band ends before a quarter of the samples, so half of a column's points are zero.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "fft.glsl"
#include "wave_fields.glsl"

// By column and kv, 0 up to and then -samples / 4 up to -1: sum and difference of h0(k) and conj(h0(-k)).
layout(set = 0, binding = 1, std430) readonly buffer Amplitudes {
    vec4 amplitudes[];
};
layout(set = 0, binding = 2, std430) readonly buffer Frequencies {
    uint frequencies[];
};
layout(set = 0, binding = 3, std430) writeonly buffer Columns {
    vec2 columns[];
};

Cascade cascadeOf(uint column) {
    Cascade found = cascades[0];
    for (uint c = 1u; c < 4u; ++c)
        if (column >= cascades[c].firstColumn) found = cascades[c];
    return found;
}

vec2 heightNow(uint mode) {
    vec4 a = amplitudes[mode];
    vec2 turn = cosineSine(frequencies[mode] * now);
    return vec2(a.x * turn.x - a.w * turn.y, a.y * turn.x + a.z * turn.y);
}

void main() {
    uint line = gl_LocalInvocationID.x / team;
    uint place = gl_LocalInvocationID.x % team;
    uint column = gl_WorkGroupID.x * lines + line;
    bool held = column < allColumns;
    column = min(column, allColumns - 1u);
    Cascade cascade = cascadeOf(column);
    float ku = cascade.dk * float(column - cascade.firstColumn);

    vec2 h[8];
    float kv[8], d[8];
#define MODE(r)                                                                                                        \
    {                                                                                                                  \
        uint n = place + team * uint(r);                                                                                  \
        h[r] = heightNow(column * (samples / 2u) + n);                                                                 \
        kv[r] = cascade.dk * (r < 4 ? float(n) : float(int(n) - int(samples / 2u)));                                   \
        float k2 = ku * ku + kv[r] * kv[r];                                                                            \
        d[r] = k2 > 0.0 ? choppiness / sqrt(k2) : 0.0;                                                                 \
    }
    MODE(0) MODE(1) MODE(2) MODE(3) MODE(4) MODE(5) MODE(6) MODE(7)

#define POINTS(F) F(0, 0) F(1, 1) F(2, 2) F(3, 3) F(12, 4) F(13, 5) F(14, 6) F(15, 7)
#define STORE(r) columns[columnPoint(column, field, place + team * uint(r))] = x[r];
#define FIELD(number, factor)                                                                                          \
    {                                                                                                                  \
        const uint field = number;                                                                                     \
        vec2 x[16];                                                                                                    \
        POINTS(factor)                                                                                                 \
        fourier16OfEnds(x);                                                                                            \
        finishLine(x, line, place);                                                                                    \
        if (held) {                                                                                                    \
            EACH(STORE)                                                                                                \
        }                                                                                                              \
    }
#define HEIGHT(r, j) x[r] = h[j];
#define SHIFT(r, j) x[r] = d[j] * h[j];
#define SHIFT_V(r, j) x[r] = (kv[j] * d[j]) * h[j];
#define SLOPE_LESS(r, j) x[r] = (kv[j] * (1.0 - kv[j] * d[j])) * h[j];
#define SLOPE_MORE(r, j) x[r] = (kv[j] * (1.0 + kv[j] * d[j])) * h[j];
    FIELD(0u, HEIGHT)
    FIELD(1u, SHIFT)
    FIELD(2u, SHIFT_V)
    FIELD(3u, SLOPE_LESS)
    FIELD(4u, SLOPE_MORE)
}
