// Texels of points on a picture. Vulkan defines float to int only for what an int holds, and looks only within the picture.

// The texel that a point falls in; the nearest to it beyond the picture, the first for what is no number.
ivec2 texelAt(vec2 point, ivec2 last) {
    return ivec2(mix(vec2(0.0), min(point, vec2(last)), greaterThan(point, vec2(0.0))));
}
