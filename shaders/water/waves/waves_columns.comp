// The waves of this moment, h(k,t) = h0(k) e^(iwt) + conj(h0(-k)) e^(-iwt), and their transforms along the columns of
// ku >= 0. A band ends before a quarter of the samples, so half of a column's points are zero.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(local_size_x_id = 2) in;   // invocations
#include "wave_fields.glsl"

// By column and kv, 0 up to and then -samples / 4 up to -1: sum and difference of h0(k) and conj(h0(-k)).
layout(set = 0, binding = amplitudesBinding, std430) readonly buffer Amplitudes {
    vec4 amplitudes[];
};
layout(set = 0, binding = frequenciesBinding, std430) readonly buffer Frequencies {
    uint frequencies[];
};
layout(set = 0, binding = columnsBinding, std430) writeonly buffer Columns {
    vec2 columns[];
};

WaveBand bandOf(uint column) {
    WaveBand found = waves.bands[0];
    for (uint c = 1u; c < 4u; ++c)
        if (column >= waves.bands[c].firstColumn) found = waves.bands[c];
    return found;
}

vec2 heightNow(uint mode) {
    vec4 a = amplitudes[mode];
    vec2 turn = cosineSine(frequencies[mode] * waves.now);
    return vec2(a.x * turn.x - a.w * turn.y, a.y * turn.x + a.z * turn.y);
}

// What a field is, of h.
float factorOf(uint field, float kv, float d) {
    if (field == 0u) return 1.0;
    if (field == 1u) return d;
    if (field == 2u) return kv * d;
    return kv * (field == 3u ? 1.0 - kv * d : 1.0 + kv * d);
}

void main() {
    uint line = gl_LocalInvocationID.x / team;
    uint place = gl_LocalInvocationID.x % team;
    uint column = gl_WorkGroupID.x * lines + line;
    bool held = column < waves.allColumns;
    column = min(column, waves.allColumns - 1u);
    WaveBand band = bandOf(column);
    float ku = band.dk * float(column - band.firstColumn);

    vec2 h[8];
    float kv[8], d[8];
#define MODE(r)                                                                                                        \
    {                                                                                                                  \
        uint n = place + team * uint(r);                                                                                  \
        h[r] = heightNow(column * (samples / 2u) + n);                                                                 \
        kv[r] = band.dk * (r < 4 ? float(n) : float(int(n) - int(samples / 2u)));                                   \
        float k2 = ku * ku + kv[r] * kv[r];                                                                            \
        d[r] = k2 > 0.0 ? waves.choppiness / sqrt(k2) : 0.0;                                                                 \
    }
    MODE(0) MODE(1) MODE(2) MODE(3) MODE(4) MODE(5) MODE(6) MODE(7)

#define POINT(r, j) x[r] = factorOf(field, kv[j], d[j]) * h[j];
#define STORE(r) columns[columnPoint(column, field, place + team * uint(r))] = x[r];
    // Each has a workgroup of its own, for as many at once; a CPU device computes a column's waves once for all.
    const uint fields = onCpu ? uint(waveColumnFields) : 1u;
    for (uint f = 0u; f < fields; ++f) {
        uint field = gl_WorkGroupID.y * fields + f;
        vec2 x[16];
        POINT(0, 0) POINT(1, 1) POINT(2, 2) POINT(3, 3) POINT(12, 4) POINT(13, 5) POINT(14, 6) POINT(15, 7)
        fourier16OfEnds(x);
        finishLine(x, line, place);
        if (held) {
            EACH(STORE)
        }
    }
}
