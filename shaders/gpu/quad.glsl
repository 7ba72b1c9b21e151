// The quad of 2 x 2 pixels that is shaded together. To be asked where all four pixels go. tile_quad.glsl is the same for kernels.

vec2 placeInQuad() {
    return vec2(ivec2(gl_FragCoord.xy) & 1);
}

// 1 for the pixel's own place of four, 0 for the others.
vec4 partOfQuad() {
    vec2 place = placeInQuad();
    vec4 columns = vec4(1.0 - place.x, place.x, 1.0 - place.x, place.x);
    return columns * vec4(1.0 - place.yy, place.yy);
}

vec4 meanOfQuad(vec4 own) {
    vec2 toMiddle = 0.5 - placeInQuad();
    vec4 row = own + toMiddle.x * dFdxFine(own);
    return row + toMiddle.y * dFdyFine(row);
}

// From this pixel to the next, whichever way is more.
vec2 changeInQuad(vec2 own) {
    return max(abs(dFdx(own)), abs(dFdy(own)));
}

// All bits of any pixel whose way through the code this one shares: its own alone, where others may leave it.
uint bitsAround(uint own) {
    return own;
}

// Of a map that repeats, as a mean over the pixel, which covers about so many `texels` across.
vec4 meanOverPixel(sampler2DArray map, vec3 at, float texels) {
    return texture(map, at);
}
