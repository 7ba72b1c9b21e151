// Smooth noise of mean 1/2, a unit from one corner of its cells to the next.
#ifndef VALUE_NOISE_GLSL
#define VALUE_NOISE_GLSL

#include "hash.glsl"

float cornerAt(ivec2 cell, uint of) {
    return shareOf(scrambled(uint(cell.x) * 0x9e3779b9u ^ uint(cell.y) * 0x85ebca6bu ^ of));
}

// `past` the cell's corner, 0..1.
float noiseWithin(ivec2 cell, vec2 past, uint of) {
    past *= past * (3.0 - 2.0 * past);
    return mix(mix(cornerAt(cell, of), cornerAt(cell + ivec2(1, 0), of), past.x),
               mix(cornerAt(cell + ivec2(0, 1), of), cornerAt(cell + ivec2(1, 1), of), past.x), past.y);
}

#endif
