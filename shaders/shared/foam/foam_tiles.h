// How large the tiles of foam's pattern are [m], for GLSL and C++ alike.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int foamTile = 24;              // of rafts; lace is a part of it
const int foamRepeat = 16 * foamTile; // after which the parts of it that places show come round again
const int windrowTile = 160;

#ifdef __cplusplus
}
#endif
