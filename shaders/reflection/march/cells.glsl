// How near the nearest thing above the plane is, as keyFromDepth() or noKey, in cells of 8 x 8 pixels and in blocks of 64 x
// 64: reflection/march/cells.h. Needs mirror.glsl.

const int cellShift = 3;
const int blockShift = 6;

int squaresAcross(int shift) {
    return (mirror.region.z + (1 << shift) - 1) >> shift;
}

int squaresDown(int shift) {
    return (mirror.region.w + (1 << shift) - 1) >> shift;
}

int cellCount() {
    return squaresAcross(cellShift) * squaresDown(cellShift);
}

// Blocks follow on cells.
int firstSquare(int shift) {
    return shift == blockShift ? cellCount() : 0;
}
