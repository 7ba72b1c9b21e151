// Needs mirror.glsl and sceneDepth.

float depthAt(ivec2 pixel) {
    return texelFetch(sceneDepth, region.xy + pixel, 0).r;
}
