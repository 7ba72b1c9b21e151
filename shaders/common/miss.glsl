// What is known of a mirrored pixel that nothing on the screen was found for. Needs mirror.glsl, reflection_info.glsl and
// sceneDepth.

float depthAt(ivec2 pixel) {
    return texelFetch(sceneDepth, region.xy + pixel, 0).r;
}

// The mirrored ray's far end tells whether the sky it would reach is on the screen.
float infoOfMiss(vec2 q) {
    vec4 end = sceneFromPixel * vec4(q, infinityDepth, 1.0);
    vec2 pixel = end.xy / end.w;
    if (!(end.w > 0.0) || !insideRegion(pixel)) return infoUnknown;
    return isFar(depthAt(ivec2(pixel))) ? infoSky : infoUnknown;
}

bool planeAhead(vec2 q) {
    return dot(heightRow, vec4(q, infinityDepth, 1.0)) < 0.0;
}
