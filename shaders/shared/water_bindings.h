// What the shaders of a body read and write, for GLSL and C++ alike: each has its number in all of them.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int bodyBinding = 0; // BodyBlock
const int meshBinding = 1; // patches, or the vertices of a mesh of the host's own
const int skyCubeBinding = 2;
const int waveDisplacementBinding = 3;
const int waveDerivativesBinding = 4;
const int waveMomentsBinding = 5;
const int shoreMapBinding = 6;
const int shoreSignalBinding = 7;
const int extentBinding = 8;
const int lastDisplacementBinding = 9;
const int foamPatternBinding = 10;
const int foamHistoryBinding = 11;
const int reflectionColorBinding = 12;
const int reflectionInfoBinding = 13;
const int sceneColorBinding = 14;
const int sceneDepthBinding = 15;
const int bedColorBinding = 16;
const int bedDepthBinding = 17;
const int sunShadowMapBinding = 18;
const int causticSumsBinding = 19;
const int causticLightBinding = 20;
const int foundDepthBinding = 22;
const int foundAsideBinding = 23;
const int foundTilesBinding = 24;
const int shadedBinding = 25;
const int sprayBinding = 26; // SprayBlock
const int mirroredBinding = 27;

#ifdef __cplusplus
}
#endif
