// Where on the mirror keys are read, from one of its pixels towards the eye, for what hangs between.
#ifndef OVERHANG_TAPS_GLSL
#define OVERHANG_TAPS_GLSL

#include "keys.glsl"
#include "screen_ray.glsl"

// What hangs lower than it is wide leaves keys in at least as many cells as lie between them and what it hides: taps may lie
// as far apart as they have gone.
const int firstTap = 3;   // [cells]
const int mostOverhangSamples = 8;   // that ReflectionDesc::overhangSamples may ask for

float farthest(vec2 apart) {
    return max(abs(apart.x), abs(apart.y));
}

// On the screen, from a pixel of the mirror to what it shows.
vec2 awayFrom(const MirrorBlock mirror, vec2 q) {
    ScreenRay ray = rayOf(mirror, q);
    vec2 away = depthSign(mirror) * (ray.origin.xy * ray.along.w - ray.along.xy * ray.origin.w);
    return away / max(farthest(away), 1e-30);
}

// Between two such taps lie two more, each as much farther: what stands on what hangs hides half of it, and seen from hardly above
// it the keys of its top are far apart, those of its edge a quarter as many as lie before them.
const int tapsPerOctave = 3;

ivec2 cellBefore(const MirrorBlock mirror, vec2 q, vec2 away, int tap) {
    int part = tap % tapsPerOctave;
    float farther = part == 0 ? 1.0 : part == 1 ? 1.26 : 1.587;
    float cells = farther * float(firstTap << (tap / tapsPerOctave));
    return texelAt(q / float(keyEdge(mirror)) - cells * away, lastCell(mirror));
}

#endif
