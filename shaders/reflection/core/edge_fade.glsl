// How a reflection fades out where the picture that it borrows from ends.
#ifndef EDGE_FADE_GLSL
#define EDGE_FADE_GLSL

#include "mirror.glsl"

// How many times `along` leads from a point to the border.
float stepsToBorder(const MirrorBlock mirror, vec2 point, vec2 along) {
    vec2 room = mix(point, vec2(regionSize(mirror)) - point, step(0.0, along));
    vec2 steps = room / max(abs(along), vec2(1e-6));
    return min(steps.x, steps.y);
}

// How far the border is from `source`, going on in the direction in which the mirror borrowed it: an upright camera
// borrows upwards, so only the top border can cut a reflection off.
float borderDistance(const MirrorBlock mirror, vec2 q, vec2 source) {
    vec2 along = source - q;
    return stepsToBorder(mirror, source, along) * length(along);
}

// By the pixels that are left to where it has faded out.
float confidenceWithin(const MirrorBlock mirror, float left) {
    // Of no width, nothing fades, nor what rounding puts on the border.
    float x = mirror.edgeFadePixels > 0.0 ? clamp(left / mirror.edgeFadePixels, 0.0, 1.0) : 1.0;
    return x * x * x * (x * (x * 6.0 - 15.0) + 10.0);
}

// Of the border ahead, or of any: the others are moved `edgeFadeApart` farther away.
float edgeConfidence(const MirrorBlock mirror, vec2 q, vec2 source) {
    vec2 aside = min(source, vec2(regionSize(mirror)) - source);
    return confidenceWithin(mirror, min(borderDistance(mirror, q, source), min(aside.x, aside.y) + mirror.edgeFadeApart));
}

#endif
