// The buffer of tiles, to shaders that read it alone.
#ifndef LISTED_TILES_GLSL
#define LISTED_TILES_GLSL

#include "tiles.glsl"

layout(set = 0, binding = tilesBinding, std430) readonly buffer Tiles {
    TileHeader header;
    uint tiles[];
};

#endif
