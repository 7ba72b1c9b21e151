// Slopes of the surface, and of a Gaussian of them: its covariance is (uu, vv, uv).
#ifndef SLOPES_GLSL
#define SLOPES_GLSL

vec3 normalOf(vec2 slope) {
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// Of what a normal of any length stands on.
vec2 slopeOf(vec3 normal) {
    return -normal.xz / max(normal.y, 1e-6);
}

// The unit vector of the calm plane that a direction runs along.
vec2 horizontal(vec3 direction) {
    return direction.xz / max(length(direction.xz), 1e-6);
}

float varianceAlong(vec2 towards, vec3 covariance) {
    return dot(towards * towards, covariance.xy) + 2.0 * towards.x * towards.y * covariance.z;
}

// Of the unit Gaussian what lies below e, within 1.4e-4 (Page 1977). Below -6 lies less than 2e-11; the power of e would
// overflow.
float gaussianBelow(float e) {
    float within = max(e, -6.0);
    return 1.0 / (1.0 + exp(-within * (1.5976 + 0.070566 * within * within)));
}

// Below what deviation a share of the unit Gaussian lies, within 3e-3 (Hastings 1955, sheet 67).
float gaussianQuantile(float share) {
    float t = sqrt(-2.0 * log(max(min(share, 1.0 - share), 1e-6)));
    float away = t - (2.30753 + 0.27061 * t) / (1.0 + t * (0.99229 + 0.04481 * t));
    return share < 0.5 ? -away : away;
}

// Mean of e - x over all x of the unit Gaussian that are less: what facets show of themselves to a ray along which they are
// edge on at slope e.
float meanAbove(float e) {
    float within = max(e, -2.0);   // below, less than 0.009, which is as good as gaussianBelow()
    return within * gaussianBelow(within) + 0.398942 * exp(-0.5 * within * within);
}

// All facets over those that are not hidden, 1 + Lambda, along a ray that is as steep as slopes of e deviations (Smith 1967).
float hiddenPer(float e) {
    return meanAbove(e) / max(e, 1e-3);
}

#endif
