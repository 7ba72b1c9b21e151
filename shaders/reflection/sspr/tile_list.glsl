// Which pixel an invocation of an indirect dispatch over a list of tiles is for. Needs tiles.glsl and the buffer Tiles.

layout(local_size_x = 8, local_size_y = 8) in;

const ivec2 noPixel = ivec2(-1);

// noPixel beyond the image and beyond the list's end.
ivec2 pixelToResolve() {
    uint n = gl_WorkGroupID.y * groupsPerRow + gl_WorkGroupID.x;
    if (n >= min(header.resolveGroups.w, tileCount())) return noPixel;
    ivec2 pixel = unpackedTile(tiles[tileCount() + n]) * tileEdge + ivec2(gl_LocalInvocationID.xy);
    return all(lessThan(pixel, imageSize())) ? pixel : noPixel;
}
