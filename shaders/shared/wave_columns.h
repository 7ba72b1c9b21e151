// How the transforms of waves lie between columns and rows, for GLSL and C++ alike:
// water/waves/wave_fields.h.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int waveColumnFields = 5; // of each column

#ifdef __cplusplus
}
#endif
