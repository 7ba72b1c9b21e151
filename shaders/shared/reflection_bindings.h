// What the shaders of reflections read and write: each has its number in all of them.
#ifdef __cplusplus
#pragma once
namespace seaglass {
#endif

const int mirrorBinding = 0;   // MirrorBlock
const int settingsBinding = 1; // the block that a shader has beside it
const int sceneDepthBinding = 2;
const int sceneColorBinding = 3;
const int surfaceNormalsBinding = 4;
const int tilesBinding = 5;
const int keysBinding = 6;
const int cellsBinding = 7;
const int sortedTilesBinding = 8; // whose flags tell which tiles are listed
const int reflectionColorBinding = 9;
const int reflectionInfoBinding = 10;
const int foundColorBinding = 11; // by this frame
const int foundInfoBinding = 12;
const int lastColorBinding = 13; // of the last
const int lastInfoBinding = 14;
const int mirroredColorBinding = 15; // as the host has drawn it
const int mirroredDepthBinding = 16;
const int overlayTargetBinding = 17;
const int finerMipBinding = 18;
const int coarserMipBinding = 19;

#ifdef __cplusplus
}
#endif
