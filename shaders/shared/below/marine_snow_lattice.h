// Where particles drift in the water around an eye, for GLSL and C++ alike: of each size a cube of cells lies
// around it, with one particle in each.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int snowSizes = 3;        // each twice the one before
const int snowCellsAcross = 16; // of a cube

#ifdef __cplusplus
}
#endif
