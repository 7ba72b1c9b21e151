// Where a mirrored ray runs behind what is seen.
#ifndef HIDDEN_WAY_GLSL
#define HIDDEN_WAY_GLSL

#include "scene_depth.glsl"
#include "screen_ray.glsl"
#include "overhang_taps.glsl"

const float backPixels = 64.0;   // that a ray is followed back to the side by which it went in
const int strideHalvings = 3;
const int hiddenStride = 1 << strideHalvings;   // [pixels], to begin with: narrower gaps may be passed over
const int mostStrides = (firstTap << mostOverhangSamples) / hiddenStride;

// Two pixels of the scene whose surfaces a ray may meet.
struct Guesses {
    ivec2 one;
    ivec2 other;
};

const ivec2 nowhere = ivec2(-1);
const Guesses noGuesses = Guesses(nowhere, nowhere);

// Where a ray goes in: between two pixels, of which what is seen at the second hides it.
struct Entry {
    Guesses between;
    vec2 hidden;   // the last point that is
    float depth;   // of the ray there, from infinityDepth
};

bool hides(const MirrorBlock mirror, vec2 point, float depth) {
    return signedDepth(mirror, fromInfinity(mirror, depthAt(mirror, regionPixel(mirror, point))) - depth) >= 0.0;
}

// How many of the next pixels of its way hide a ray, whose depth is linear there: looked for in strides, then in pixels.
float hiddenPixels(const MirrorBlock mirror, ScreenRay ray, vec2 from, vec2 step, float pixels) {
    float depth = rayDepthAt(ray, from);
    float perPixel = (rayDepthAt(ray, from + pixels * step) - depth) / max(pixels, 1.0);
    float hidden = 0.0;
    float shown = 0.0;
    int strides = mostStrides;
    do {
        float next = min(hidden + float(hiddenStride), pixels);
        bool still = hides(mirror, from + next * step, depth + next * perPixel);
        hidden = still ? next : hidden;
        shown = still ? 0.0 : next;
    } while (--strides > 0 && shown == 0.0 && hidden < pixels);
    int less = hiddenStride / 2;
    int halvings = strideHalvings;
    do {
        float next = hidden + float(less);
        bool still = next < shown && hides(mirror, from + next * step, depth + next * perPixel);
        hidden = still ? next : hidden;
        less /= 2;
    } while (--halvings > 0);
    return hidden;
}

// Back towards the mirror from a point at which the ray is hidden.
Entry entryBefore(const MirrorBlock mirror, ScreenRay ray, vec2 q, vec2 from, float mostPixels) {
    vec2 back = q - from;
    float way = farthest(back);
    vec2 step = back / max(way, 1e-6);
    float pixels = min(floor(way), mostPixels);
    float hidden = hiddenPixels(mirror, ray, from, step, pixels);
    vec2 point = from + hidden * step;
    Guesses between = Guesses(regionPixel(mirror, point + step), regionPixel(mirror, point));
    return Entry(hidden < pixels ? between : noGuesses, point, rayDepthAt(ray, point));
}

// The last hidden point of a ray before it is seen again.
vec2 exitAfter(const MirrorBlock mirror, ScreenRay ray, vec2 from, vec2 step, float mostPixels) {
    vec2 left = (mix(vec2(0.0), vec2(regionSize(mirror)), greaterThan(step, vec2(0.0))) - from) / step;
    left = mix(left, vec2(mostPixels), lessThan(abs(step), vec2(1e-3)));
    float pixels = clamp(floor(min(left.x, left.y)) - 1.0, 0.0, mostPixels);
    return from + hiddenPixels(mirror, ray, from, step, pixels) * step;
}

#endif
