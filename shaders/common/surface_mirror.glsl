// What the surface mirrors: an integral over the slopes that the eye can see, along the line of sight, each with its own
// Fresnel term and weighted by its visible area. Without it the mean normal makes the far sea a mirror of the horizon.

#ifdef REFLECTION
#include "reflection_lookup.glsl"
#endif

vec3 skyAt(vec3 direction, float spread) {
    // A cube texel spans about pi/2 / edge; `spread` is the standard deviation of the mirrored direction, two of which
    // a texel of the mip should span. No mirrored ray comes from below the horizon, so neither may the blur.
    float texel = 0.5 * pi / exp2(skyMips - 1.0);
    float mip = clamp(log2(max(2.0 * spread / texel, 1.0)), 0.0, max(skyMips - 2.0, 0.0));
    return textureLod(skyCube, vec3(direction.x, max(direction.y, spread), direction.z), mip).rgb;
}

vec3 mirroredRadiance(vec3 direction, float spread) {
    vec3 sky = skyAt(direction, spread);
#ifdef REFLECTION
    vec4 screen = reflectionAlong(position, direction, spread);
    return sky * (1.0 - screen.a) + screen.rgb;
#else
    return sky;
#endif
}

struct Reflection {
    vec3 radiance;   // times Fresnel
    float fresnel;
};

vec3 keptAbove(vec3 direction) {
    return normalize(vec3(direction.x, max(abs(direction.y), 1e-3), direction.z));
}

// What a facet mirrors. Low rays meet another wave before they reach the sky (Smith's masking by all the sea's slopes);
// that wave's facets lean towards the ray by 1.25 deviations in the mean, and mirror a higher part of the sky in turn.
vec3 mirroredBySea(vec3 direction, float spread) {
    vec3 first = mirroredRadiance(keptAbove(direction), spread);
    if (roughness.w <= 0.0) return first;
    float clear = direction.y > 0.0 ? 1.0 / (1.0 + smithLambda(direction.y, roughness.w)) : 0.0;
    vec2 along = direction.xz / max(length(direction.xz), 1e-6);
    vec3 facet = normalOf(along * (1.25 * roughness.w));
    vec3 second = keptAbove(reflect(direction, facet));
    return first * clear + skyAt(second, spread) * (fresnelWater(dot(-direction, facet)) * (1.0 - clear));
}

// Midpoint rule over the visible slopes: within 2.5 deviations, and less than what turns a facet edge on. Three points
// give a variance of 0.92 seen from above and a mean tilt of 1.15 deviations at grazing, where 1.25 is exact.
Reflection reflected(SurfacePoint s, vec3 toEye) {
    float horizontal = max(length(toEye.xz), 1e-6);
    vec2 towards = toEye.xz / horizontal;
    float alongVariance =
        dot(towards * towards, s.covariance.xy) + 2.0 * towards.x * towards.y * s.covariance.z;
    float deviation = sqrt(max(alongVariance, 1e-10));
    float edgeOn = toEye.y / horizontal - dot(s.slope, towards);
    float low = -2.5 * deviation;
    float high = clamp(edgeOn, -2.0 * deviation, 2.5 * deviation);
    int points = deviation > 2e-3 ? 3 : 1;
    float width = (high - low) / float(points);
    // Of a uniform segment, and from this pixel to the next; mirroring doubles angles.
    float spread = 2.0 * (width * 0.288675 + 0.5 * s.slopeStep);
    Reflection sum = Reflection(vec3(0.0), 0.0);
    float weights = 0.0;
    for (int i = 0; i < points; ++i) {
        float offset = points == 1 ? 0.0 : low + (float(i) + 0.5) * width;
        vec2 slope = s.slope + towards * offset;
        float relative = offset / deviation;
        // A trace is kept of facets seen from behind, so that the sum is never empty.
        float weight = exp(-0.5 * relative * relative) * max(edgeOn - offset, 1e-4);
        vec3 normal = normalOf(slope);
        float fresnel = fresnelWater(dot(toEye, normal));
        sum.radiance += weight * fresnel * mirroredBySea(reflect(-toEye, normal), spread);
        sum.fresnel += weight * fresnel;
        weights += weight;
    }
    sum.radiance /= weights;
    sum.fresnel /= weights;
    return sum;
}
