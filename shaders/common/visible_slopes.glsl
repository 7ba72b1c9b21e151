// The slopes within a pixel that a line of sight can see, as a few points of the midpoint rule: within 2.5 deviations, and
// less than what turns a facet edge on. Three points give a variance of 0.92 seen from above and a mean tilt of 1.15
// deviations at grazing, where 1.25 is exact. Needs SurfacePoint and slopes.glsl.

struct VisibleSlopes {
    vec2 towards;      // unit, to which slopes are offset
    float deviation;   // of all slopes along it
    float edgeOn;      // offset at which a facet is seen edge on
    float low, width;  // of the offsets, and of each point's share
    float spread;      // deviation within a point's share
    int points;
};

// `side` runs along the line of sight, to where it is above the surface; `most` points are taken where it is rough.
VisibleSlopes visibleSlopes(SurfacePoint s, vec3 side, int most) {
    VisibleSlopes v;
    v.towards = horizontal(side);
    v.deviation = sqrt(max(varianceAlong(v.towards, s.covariance), 1e-10));
    v.edgeOn = side.y / max(length(side.xz), 1e-6) - dot(s.slope, v.towards);
    v.low = -2.5 * v.deviation;
    float high = clamp(v.edgeOn, -2.0 * v.deviation, 2.5 * v.deviation);
    v.points = v.deviation > 2e-3 ? most : 1;
    v.width = (high - v.low) / float(v.points);
    v.spread = v.width * 0.288675;   // of a uniform share
    return v;
}

float offsetOf(VisibleSlopes v, int i) {
    return v.points == 1 ? 0.0 : v.low + (float(i) + 0.5) * v.width;
}

float weightOf(VisibleSlopes v, float offset) {
    float relative = offset / v.deviation;
    // A trace is kept of facets seen from behind, so that the sum is never empty.
    return exp(-0.5 * relative * relative) * max(v.edgeOn - offset, 1e-4);
}

float deviationAcross(SurfacePoint s, vec2 towards) {
    return sqrt(max(varianceAlong(vec2(-towards.y, towards.x), s.covariance), 1e-10));
}
