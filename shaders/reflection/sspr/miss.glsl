// What is known of a mirrored pixel that nothing on the screen was found for. Needs mirror.glsl, reflection_info.glsl and
// scene_depth.glsl.

// Where the far end of a mirrored ray shows. Affine in the mirror's pixel.
struct FarEnd {
    vec4 point;    // on the scene's screen [pixel], times w
    float ahead;   // of the plane's horizon, where it is negative
};

FarEnd farEndOf(vec2 q) {
    return FarEnd(mirror.skyFromPixel * vec3(q, 1.0), dot(mirror.heightRow, vec4(q, mirror.infinityDepth, 1.0)));
}

FarEnd farEndPerRow(float pixels) {
    return FarEnd(pixels * mirror.skyFromPixel[1], pixels * mirror.heightRow.y);
}

// The mirrored ray's far end tells whether the sky it would reach is on the screen.
float infoOfFarEnd(FarEnd end) {
    vec2 pixel = end.point.xy / end.point.w;
    bool onScreen = end.ahead < 0.0 && end.point.w > 0.0 && insideRegion(pixel);
    return onScreen && isFar(depthAt(onScreen ? ivec2(pixel) : ivec2(0))) ? infoSky : infoUnknown;
}

float infoOfMiss(vec2 q) {
    return infoOfFarEnd(farEndOf(q));
}

bool planeAhead(vec2 q) {
    return dot(mirror.heightRow, vec4(q, mirror.infinityDepth, 1.0)) < 0.0;
}
