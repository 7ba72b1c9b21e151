// What the kernels of waves and foam read and write: each has its number in all of them.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int wavesBinding = 0; // WavesBlock
const int amplitudesBinding = 1;
const int frequenciesBinding = 2;
const int columnsBinding = 3;
const int displacementMapBinding = 4;
const int derivativeMapBinding = 5;
const int momentMapBinding = 6;
const int foamBinding = 7; // FoamBlock
const int foamStepsBinding = 8;

#ifdef __cplusplus
}
#endif
