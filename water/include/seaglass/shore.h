// How wet the waves of a shore keep its sand, for the host's own materials: numbers for its shaders, which
// include shore_wetness.glsl, and the same on the CPU. Sand is the host's; only the water over it is drawn
// here.
#pragma once

#include <cstdint>

namespace seaglass {

struct Sea;

/// SeaglassShore of shore_wetness.glsl, in std140 and std430.
struct ShoreBlock {
    float place[4] = {}; ///< the eye on the map, in texels; texels to a metre; 0
    float rows[4] = {};  ///< in a second; the first; how many a train has, 0: no shore; from look to look
    float form[4] = {};  ///< looks; seconds from one to the next; in which sand dries; what no edge has
                         ///< passed, in the map's own
};

/// What wets a place of the sand.
struct ShoreWetness {
    double wet = 0;   ///< 1: soaked, 0: dry
    double under = 0; ///< share of it under water or a film of it, which draw() shades
};

/// The map of shore_wetness.glsl: RGBA32F, as many texels as ShoreDesc::samples, rows along u. In each the
/// seconds until three wave trains arrive, and how far the water's edge moves [m]. False, and nothing
/// written, without a shore. Any thread.
bool shoreTexels(const Sea& sea, float* out);

/// Texels of the map along u and v; 0 without a shore.
void shoreSamples(const Sea& sea, uint32_t out[2]);

/// Rows of four floats that shoreRows() writes; 0 without a shore. `dryingTime`: from the last water to dry
/// sand [s], 1..300.
uint32_t shoreRowCount(const Sea& sea, double dryingTime);

/// What the waves do to the sand at `time`, and have done before it: a function of the time alone, whatever
/// frames came before. `eye`: (u, v) that places are relative to in shaders. Any thread.
ShoreBlock shoreRows(const Sea& sea, double time, double dryingTime, const double eye[2], float* rows);

/// At (u, v) from `eye` of the block, `height` over the calm plane [m], as seaglass_wetness() has it. Any
/// thread.
ShoreWetness shoreWetness(const Sea& sea, const ShoreBlock& block, const float* rows, double u, double v,
                          double height);

} // namespace seaglass
