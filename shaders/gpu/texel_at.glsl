// Texels of points on a picture. Vulkan defines float to int only for what an int holds, and looks only within the picture.
#ifndef TEXEL_AT_GLSL
#define TEXEL_AT_GLSL

// The point itself; the nearest to it where it lies beyond the picture, the first where it is no number.
vec2 pointWithin(vec2 point, ivec2 size) {
    return mix(vec2(0.0), min(point, vec2(size) - 0.5), greaterThan(point, vec2(0.0)));
}

// The texel that a point falls in, likewise.
ivec2 texelAt(vec2 point, ivec2 last) {
    return ivec2(mix(vec2(0.0), min(point, vec2(last)), greaterThan(point, vec2(0.0))));
}

#endif
