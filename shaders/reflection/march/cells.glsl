// How near the nearest thing above the plane is, as keyFromDepth() or noKey, in cells of 8 x 8 pixels and in blocks of 64 x
// 64: reflection/march/cells.h.
#ifndef CELLS_GLSL
#define CELLS_GLSL

#include "mirror.glsl"

const int cellShift = 3;
const int blockShift = 6;

int squaresAcross(const MirrorBlock mirror, int shift) {
    return (regionSize(mirror).x + (1 << shift) - 1) >> shift;
}

int squaresDown(const MirrorBlock mirror, int shift) {
    return (regionSize(mirror).y + (1 << shift) - 1) >> shift;
}

int cellCount(const MirrorBlock mirror) {
    return squaresAcross(mirror, cellShift) * squaresDown(mirror, cellShift);
}

// Blocks follow on cells.
int firstSquare(const MirrorBlock mirror, int shift) {
    return shift == blockShift ? cellCount(mirror) : 0;
}

#endif
