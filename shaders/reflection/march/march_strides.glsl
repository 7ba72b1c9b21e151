// Where a ray goes behind what is seen, by strides and bisection.
#ifndef MARCH_STRIDES_GLSL
#define MARCH_STRIDES_GLSL

#include "march.glsl"

const int bisections = 6;

Progress atStart(Track track, float noise) {
    float stride = max(2.0 * track.halfPixel, 1.0 / float(settings.steps));
    Seen seen = seenAt(track.scene, pixelAt(track.scene, track.first.xy));
    float halfPixel = track.halfPixel * abs(track.along.z);
    bool isBehind = seen.counts && seen.depth >= track.first.z - halfPixel;
    return Progress(-settings.jitter * noise * stride, !isBehind, false, noCover, settings.steps + 1);
}

// Closes in on where a ray goes behind what is seen between two strides, or where it `leaves`.
Crossing bisected(Track track, float low, float high, bool inFront, bool leaves) {
    float halfPixel = track.halfPixel * abs(track.along.z);
    float hidden = leaves ? low : high;
    bool close = false;
    int i = 0;
    do {
        float share = i < bisections ? 0.5 * (low + high) : hidden;
        vec3 point = trackPoint(track, share);
        Seen seen = seenAt(track.scene, pixelAt(track.scene, point.xy));
        bool isBehind = seen.counts && seen.depth >= point.z - halfPixel;
        close = within(track, share, point.z + halfPixel, seen.depth);
        bool crossed = leaves ? !isBehind : isBehind && (inFront || close);
        high = crossed ? share : high;
        low = crossed ? low : share;
        hidden = leaves ? low : high;
        inFront = inFront || !isBehind;
    } while (++i <= bisections);
    return Crossing(close, hidden, vec3(0.0), hidden - track.halfPixel, hidden + track.halfPixel, close, false, inSight);
}

// The next stride on which the ray may cross what is seen, or come out of it. The interval of depth that the ray has over
// a pixel is compared, not its middle: otherwise the last row of every edge is missed.
Crossing nextCrossing(const MirrorBlock mirror, Track track, inout Progress at) {
    float stride = max(2.0 * track.halfPixel, 1.0 / float(settings.steps));
    float halfPixel = track.halfPixel * abs(track.along.z);
    float nearer = max(-track.along.z * stride, 0.0) + halfPixel;
    float last = at.reached;
    bool wasInFront = at.inFront;
    bool candidate = false;
    bool leaves = false;
    bool ends = false;
    if (at.taps > 0 && at.reached < 1.0) {
        do {
            --at.taps;
            last = at.reached;
            wasInFront = at.inFront;
            at.reached = min(at.reached + stride, 1.0);
            vec3 point = trackPoint(track, at.reached);
            Seen seen = seenAt(track.scene, pixelAt(track.scene, point.xy));
            bool isBehind = seen.counts && seen.depth >= point.z - halfPixel;
            at.inFront = !isBehind;
            at.hidden = at.hidden || isBehind;
            leaves = !isBehind && !wasInFront;
            candidate = leaves || isBehind && within(track, at.reached, point.z + nearer, seen.depth);
            ends = coverEnds(track, max(last, 0.0), point.z, seen, isBehind, at.cover);
            if (candidate || ends) break;
        } while (at.taps > 0 && at.reached < 1.0);
    }
    if (ends && !candidate)
        return Crossing(true, at.reached, vec3(0.0), at.reached - track.halfPixel, at.reached + track.halfPixel, false, false,
                        at.cover.from);
    if (!candidate) return noCrossing;
    return bisected(track, max(last, 0.0), at.reached, wasInFront, leaves);
}

#endif
