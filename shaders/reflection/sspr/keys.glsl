// The keys that the scatter left.
#ifndef KEYS_GLSL
#define KEYS_GLSL

#include "mirror.glsl"

layout(set = 0, binding = keysBinding, std430) readonly buffer Keys {
    uint keys[];
};

ivec2 lastCell(const MirrorBlock mirror) {
    return keyGrid(mirror) - 1;
}

// Beyond the border its own keys again, which have had their turn.
uint keyAt(const MirrorBlock mirror, ivec2 cell) {
    ivec2 last = lastCell(mirror);
    cell = clamp(cell, ivec2(0), last);
    return keys[cell.y * (last.x + 1) + cell.x];
}

#endif
