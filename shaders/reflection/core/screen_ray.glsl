// Mirrored rays on the screen.
#ifndef SCREEN_RAY_GLSL
#define SCREEN_RAY_GLSL

#include "mirror.glsl"

// The mirrored ray of a pixel as screen points whose depth counts from infinityDepth: origin + mirroredDepth * along.
struct ScreenRay {
    vec4 origin;
    vec4 along;
};

ScreenRay rayOf(const MirrorBlock mirror, vec2 q) {
    vec4 origin = mirror.sceneFromPixel * vec4(q, 0.0, 1.0);
    vec4 along = mirror.sceneFromPixel[2];
    origin.z = dot(mirror.depthRow, vec4(q, 0.0, 1.0));
    along.z = mirror.depthRow.z;
    return ScreenRay(origin, along);
}

// The mirrored depth of a ray at a point of the line that it is on the screen.
float depthOn(ScreenRay ray, vec2 point) {
    vec2 start = ray.origin.xy - point * ray.origin.w;
    vec2 along = ray.along.xy - point * ray.along.w;
    return abs(along.x) > abs(along.y) ? -start.x / along.x : -start.y / along.y;
}

float rayDepthAt(ScreenRay ray, vec2 point) {
    vec4 there = ray.origin + depthOn(ray, point) * ray.along;
    return there.z / there.w;
}

#endif
