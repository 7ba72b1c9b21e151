// One view of a body's spray, for GLSL and C++ alike: water/spray/spray_lattice.h. Metres and seconds, of the
// eye and in the body's axes as BodyBlock.
#ifdef __cplusplus
#pragma once
#include "gpu/pipeline/shader_types.h"
namespace seaglass {
#endif

const int sprayLevels = 6;

// What the air tears spray by comes round again after so many metres across the wind, and downwind as many
// times its stretch.
const int sprayAirRepeat = 512;
const float sprayAirStretch = 6.0f;

struct SprayBlock {
    ivec4 cells[sprayLevels]; // the first along u and v, as they wrap; how many along u; the first particle
    vec4 places[sprayLevels]; // (u, v) of the first one's corner, a cell's edge, how far away it ends
    vec4 wind; // the air's speed at the crests along u and v; how long drops are seen; how fast crests run
    vec4 foam; // of the cascade that breaks most: in which its odds fade to 1/e, from one of its steps to the
               // next, floor of its fading (water/foam/foam_fading.h), which it is
    vec4 form; // optical depth of what is torn off a level square metre; shutter time; where in the air that
               // blows past the eye is, downwind and across, less whole sprayAirRepeats
};

#ifdef __cplusplus
}
#endif
