// Needs mirror.glsl and sceneDepth.

float depthAt(ivec2 pixel) {
    return texelFetch(sceneDepth, mirror.region.xy + pixel, 0).r;
}

// Whether what shows at a pixel can be mirrored: neither the far plane nor deeper under the mirror than is told apart.
bool solid(ivec2 pixel, float depth) {
    return !isFar(depth) && !wellBelowPlane(vec3(vec2(pixel) + 0.5, depth));
}
