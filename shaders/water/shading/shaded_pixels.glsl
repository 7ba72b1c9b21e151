// Which pixel of a block is shaded. Needs foundDepth and shading_block.glsl.

bool showsSurface(ivec2 at) {
    return inRegion(vec2(at)) && texelFetch(foundDepth, at, 0).r > 0.0;
}

// The usual one, and at the surface's edge the first that shows any.
ivec2 shadedPixel(ivec2 block) {
    ivec2 first = block * blockSize();
    ivec2 usual = first + ivec2(shiftOfRow(first.y), 0);
    if (allAreShaded() || showsSurface(usual)) return usual;
    for (int i = 0; i < blockWidth; ++i)
        if (showsSurface(first + ivec2(i, 0))) return first + ivec2(i, 0);
    return usual;
}
