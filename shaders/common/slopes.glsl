// Slopes of the surface, and of a Gaussian of them: its covariance is (uu, vv, uv).

vec3 normalOf(vec2 slope) {
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// The unit vector of the calm plane that a direction runs along.
vec2 horizontal(vec3 direction) {
    return direction.xz / max(length(direction.xz), 1e-6);
}

float varianceAlong(vec2 towards, vec3 covariance) {
    return dot(towards * towards, covariance.xy) + 2.0 * towards.x * towards.y * covariance.z;
}
