// What foam's fading has in common for GLSL and C++ alike: water/foam/foam_fading.h.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const float foamOddsScale = 10.0f / 9.0f; // full foam has odds of 9
const float foamMostOdds = 9.0f;

#ifdef __cplusplus
}
#endif
