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

// Share of the rays of this rise that meet no other wave.
float clearShare(float rise) {
    return rise > 0.0 ? 1.0 / (1.0 + smithLambda(rise, roughness.w)) : 0.0;
}

// What a facet mirrors. Low rays meet another wave before they reach the sky (Smith's masking by all the sea's slopes);
// that wave's facets lean towards the ray by 1.25 deviations in the mean, and mirror a higher part of the sky in turn.
vec3 mirroredBySea(vec3 direction, float spread) {
    vec3 first = mirroredRadiance(keptAbove(direction), spread);
    if (roughness.w <= 0.0) return first;
    // It bends where few points of the slopes lie: two of their spread's ends are within 3 % of its mean.
    float clear = 0.5 * (clearShare(direction.y - 1.2 * spread) + clearShare(direction.y + 1.2 * spread));
    vec2 along = direction.xz / max(length(direction.xz), 1e-6);
    vec3 facet = normalOf(along * (1.25 * roughness.w));
    vec3 second = keptAbove(reflect(direction, facet));
    return first * clear + skyAt(second, spread) * (fresnelWater(dot(-direction, facet)) * (1.0 - clear));
}

Reflection reflected(SurfacePoint s, vec3 toEye) {
    VisibleSlopes v = visibleSlopes(s, toEye, 3);
    // From this pixel to the next too; mirroring doubles angles.
    float spread = 2.0 * (v.spread + 0.5 * s.slopeStep);
    Reflection sum = Reflection(vec3(0.0), 0.0);
    float weights = 0.0;
    for (int i = 0; i < v.points; ++i) {
        float offset = offsetOf(v, i);
        float weight = weightOf(v, offset);
        vec3 normal = normalOf(s.slope + v.towards * offset);
        float fresnel = fresnelWater(dot(toEye, normal));
        sum.radiance += weight * fresnel * mirroredBySea(reflect(-toEye, normal), spread);
        sum.fresnel += weight * fresnel;
        weights += weight;
    }
    sum.radiance /= weights;
    sum.fresnel /= weights;
    return sum;
}
