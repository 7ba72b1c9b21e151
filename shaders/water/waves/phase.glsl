// Phases of waves as water/sea/phase.h forms them: 2^32 to a turn, wrapped, so that they are exact at any time.
#ifndef PHASE_GLSL
#define PHASE_GLSL

// (cosine, sine), within 1.3e-7. GPUs promise 2^-11 for their own.
vec2 cosineSine(uint phase) {
    // The nearest quarter turn is taken off as an integer, which is exact; in [-pi/4, pi/4] short series do.
    uint quarter = (phase + 0x20000000u) & 0xc0000000u;
    float x = float(int(phase - quarter)) * 1.4629180792671596e-9;
    float x2 = x * x;
    float sine = x + x * x2 * (-1.6666654611e-1 + x2 * (8.3321608736e-3 - x2 * 1.9515295891e-4));
    float cosine = 1.0 - 0.5 * x2 +
                   x2 * x2 * (4.166664568298827e-2 + x2 * (-1.388731625493765e-3 + x2 * 2.443315711809948e-5));
    bool odd = (quarter & 0x40000000u) != 0u;
    float sineSign = (quarter & 0x80000000u) != 0u ? -1.0 : 1.0;
    float cosineSign = ((quarter + 0x40000000u) & 0x80000000u) != 0u ? -1.0 : 1.0;
    return vec2(cosineSign * (odd ? sine : cosine), sineSign * (odd ? cosine : sine));
}

#endif
