// Which pixels are shaded, of a surface of which one of 2 or of 4 is. Needs foundDepth and found_tiles.glsl.
//
// Along a row, as water is seen flatly: there a pixel is far longer than wide, and the next of its row is the most like it. Every
// other row's lie in the middle between those of the rows beside it.

bool showsSurface(ivec2 at) {
    return inRegion(vec2(at)) && texelFetch(foundDepth, at, 0).r > 0.0;
}

int shiftOfRow(int y) {
    return (y & 1) * int(pixelsPerShading) / 2;
}

// Of a block the usual pixel, and at the surface's edge the first that shows any.
ivec2 shadedPixel(ivec2 block) {
    ivec2 first = block * blockSize();
    ivec2 usual = first + ivec2(shiftOfRow(first.y), 0);
    if (pixelsPerShading == 1u || showsSurface(usual)) return usual;
    for (int i = 0; i < blockSize().x; ++i)
        if (showsSurface(first + ivec2(i, 0))) return first + ivec2(i, 0);
    return usual;
}
