// How wet the waves of a shore keep its sand, which is the host's to draw: numbers for its shaders, which
// include shore_wetness.glsl, and the same on the CPU.
#pragma once

#include <cstdint>

namespace seaglass {

struct Sea;

/// SeaglassShore of shore_wetness.glsl, in std140 and std430.
struct ShoreBlock {
    float place[4] = {}; ///< the eye on the map, in texels; texels to a metre; 0
    float rows[4] = {};  ///< in a second; the first; how many a train has, 0: no shore; from sample to sample
    float form[4] =
        {}; ///< samples of the past; seconds between them; in which sand dries; what no edge has passed
};

/// What wets a place of the sand.
struct ShoreWetness {
    double wet = 0;   ///< 1: soaked, 0: dry
    double under = 0; ///< share of it under water or a film of it, which draw() shades
};

/// The map of shore_wetness.glsl: RGBA32F, as many texels as ShoreDesc::samples, rows along u; in each the
/// seconds until three wave trains arrive, and how far its edge moves [m]. False: no shore. Any thread.
bool shoreTexels(const Sea& sea, float* out);

void shoreSamples(const Sea& sea, uint32_t out[2]); ///< the map's texels along u and v; 0: no shore

/// Rows of four floats of shoreRows(); 0: no shore. `dryingTime`: from water to dry sand [s], 1..300.
uint32_t shoreRowCount(const Sea& sea, double dryingTime);

/// What waves do to the sand at `time`, and did before: a function of the time alone. `eye`: the (u, v) that
/// shaders' places are relative to. Any thread.
ShoreBlock shoreRows(const Sea& sea, double time, double dryingTime, const double eye[2], float* rows);

/// As seaglass_wetness() at (u, v) from the block's eye, `height` over the calm plane [m]. Any thread.
ShoreWetness shoreWetness(const Sea& sea, const ShoreBlock& block, const float* rows, double u, double v,
                          double height);

} // namespace seaglass
