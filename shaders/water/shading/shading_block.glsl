// Blocks of pixels of which one is shaded, and the others completed: so many beside each other in a row.
//
// Along a row, as water is seen flatly: there a pixel is far longer than wide, and the next of its row is the most like it. Every
// other row's shaded pixels lie in the middle between those of the rows beside it.
#ifndef SHADING_BLOCK_GLSL
#define SHADING_BLOCK_GLSL

#include "body.glsl"

const int blockWidth = int(pixelsPerShading);   // [pixel]

// Each pixel is a block of its own.
bool allAreShaded() {
    return blockWidth == 1;
}

ivec2 blockSize() {
    return ivec2(blockWidth, 1);
}

// Of the shaded pixels of a row, to the right of where its blocks begin.
int shiftOfRow(int y) {
    return (y & 1) * blockWidth / 2;
}

#endif
