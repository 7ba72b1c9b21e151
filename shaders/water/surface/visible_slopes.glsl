// The slopes within a pixel that a line of sight can see, as a few points.
#ifndef VISIBLE_SLOPES_GLSL
#define VISIBLE_SLOPES_GLSL

#include "surface_point.glsl"
#include "slopes.glsl"

struct VisibleSlopes {
    vec2 towards;      // unit, to which slopes are offset
    float deviation;   // of all slopes along it
    float edgeOn;      // offset at which a facet is seen edge on
};

// `side` runs along the line of sight, to where it is above the surface.
VisibleSlopes visibleSlopes(const SurfacePoint s, vec3 side) {
    VisibleSlopes v;
    v.towards = horizontal(side);
    v.deviation = sqrt(max(varianceAlong(v.towards, s.covariance), 1e-10));
    v.edgeOn = side.y / max(length(side.xz), 1e-6) - dot(s.slope, v.towards);
    return v;
}

float deviationAcross(const SurfacePoint s, vec2 towards) {
    return sqrt(max(varianceAlong(vec2(-towards.y, towards.x), s.covariance), 1e-10));
}

// All that is seen along the line of sight, as a mean offset, the deviation from it, and how lopsided it is: 0 from above,
// where it is a Gaussian, 1 where the mean plane is edge on, which leaves a Rayleigh distribution.
struct SlopeSpread {
    float mean, deviation, skew;
};

// In deviations, slopes x of the density phi show areas as e - x, where e is edge on. So they have the mean
// m = -Phi / (e Phi + phi), and the variance 2 + m (e - m). Their third moment is fitted, within 0.02 of Rayleigh's.
SlopeSpread slopeSpread(VisibleSlopes v) {
    float e = clamp(v.edgeOn / v.deviation, -1.5, 20.0);
    float mean = -gaussianBelow(e) / meanAbove(e);
    float skew = 1.75 / (1.0 + 0.75 * exp(0.911 * e));
    return SlopeSpread(v.deviation * mean, v.deviation * sqrt(2.0 + mean * (e - mean)), skew);
}

// How large level area is to the eye, its facets that are seen from behind left out: Smith's masking by all its slopes.
float visibleArea(VisibleSlopes v, vec3 side) {
    return max(max(length(side.xz), 1e-6) * v.deviation * meanAbove(v.edgeOn / v.deviation), 1e-4);
}

// Points by the midpoint rule, where what is seen ends at some slope: within three deviations, less than edge on, and up to the last
// that counts. A point beyond that would make rings of what ends there.
struct SlopeSteps {
    float low, width;  // of the offsets, and of each point's share
    float spread;      // deviation within a point's share
    int points;
};

// Of facets seen from behind a trace is kept, so that something is seen.
float leastEdgeOn(VisibleSlopes v) {
    return max(v.edgeOn / v.deviation, -2.0);
}

// `most` points are taken where it is rough.
SlopeSteps slopeSteps(VisibleSlopes v, int most, float last) {
    const float within = 3.0;
    SlopeSteps steps;
    steps.low = -within * v.deviation;
    float high = min(v.deviation * min(leastEdgeOn(v), within), last);
    steps.points = v.deviation > 2e-3 ? most : 1;
    steps.width = max(high - steps.low, 0.0) / float(steps.points);
    steps.spread = steps.width * 0.288675;   // of a uniform share
    return steps;
}

float offsetOf(SlopeSteps steps, int i) {
    return steps.points == 1 ? 0.0 : steps.low + (float(i) + 0.5) * steps.width;
}

// Of all that is seen, those beyond the last included.
float shareSeen(SlopeSteps steps, VisibleSlopes v, float offset) {
    float x = offset / v.deviation, edgeOn = leastEdgeOn(v);
    float share = 0.398942 * exp(-0.5 * x * x) * max(edgeOn - x, 0.0) / meanAbove(edgeOn) * steps.width / v.deviation;
    return steps.points == 1 ? 1.0 : share;
}

#endif
