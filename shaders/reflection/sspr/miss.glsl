// What is known of a mirrored pixel that nothing on the screen was found for.
#ifndef MISS_GLSL
#define MISS_GLSL

#include "scene_depth.glsl"
#include "reflection_info.glsl"

// Where the far end of a mirrored ray shows. Affine in the mirror's pixel.
struct FarEnd {
    vec4 point;    // on the scene's screen [pixel], times w
    float ahead;   // of the plane's horizon, where it is negative
};

FarEnd farEndOf(const MirrorBlock mirror, vec2 q) {
    return FarEnd(mirror.skyFromPixel * vec3(q, 1.0), heightAtInfinity(mirror, q));
}

FarEnd farEndPerRow(const MirrorBlock mirror, float pixels) {
    return FarEnd(pixels * mirror.skyFromPixel[1], pixels * heightAtInfinityPerRow(mirror));
}

// The mirrored ray's far end tells whether the sky it would reach is on the screen.
float infoOfFarEnd(const MirrorBlock mirror, FarEnd end) {
    vec2 pixel = end.point.xy / end.point.w;
    bool onScreen = end.ahead < 0.0 && end.point.w > 0.0 && insideRegion(mirror, pixel);
    return onScreen && isFar(mirror, depthAt(mirror, onScreen ? ivec2(pixel) : ivec2(0))) ? infoSky : infoUnknown;
}

float infoOfMiss(const MirrorBlock mirror, vec2 q) {
    return infoOfFarEnd(mirror, farEndOf(mirror, q));
}

bool planeAhead(const MirrorBlock mirror, vec2 q) {
    return heightAtInfinity(mirror, q) < 0.0;
}

#endif
