// Which column of a tile an invocation of an indirect dispatch over the list of columns is for. Needs tiles.glsl and the
// buffer Tiles.

layout(local_size_x = tileEdge * tilesPerColumnGroup, local_size_y = 1) in;

struct Column {
    ivec2 top;
    int rows;   // within the image; none beyond the list's end
};

Column columnToVisit() {
    uint group = gl_WorkGroupID.y * groupsPerRow + gl_WorkGroupID.x;
    uint n = group * tilesPerColumnGroup + (gl_LocalInvocationID.x >> tileShift);
    if (n >= min(header.columnGroups.w, tileCount())) return Column(ivec2(0), 0);
    ivec2 tile = unpackedTile(tiles[2u * tileCount() - 1u - n]);
    ivec2 top = tile * tileEdge + ivec2(gl_LocalInvocationID.x & (tileEdge - 1), 0);
    ivec2 size = imageSize();
    return Column(top, top.x < size.x ? clamp(size.y - top.y, 0, tileEdge) : 0);
}
