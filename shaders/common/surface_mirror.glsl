// What the surface mirrors: an integral over the slopes that the eye can see, along the line of sight, each with its own
// Fresnel term and weighted by its visible area. Without it the mean normal makes the far sea a mirror of the horizon.
//
// Loops of one round stand for branches: CPU devices leave them out where nobody is in them.

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

vec3 keptAbove(vec3 direction) {
    return normalize(vec3(direction.x, max(abs(direction.y), 1e-3), direction.z));
}

// `hit` is how far away the last ray beside this one met something [m].
vec3 mirroredRadiance(vec3 direction, float spread, inout float hit) {
    vec4 found = vec4(0.0);
#ifdef REFLECTION
    found = reflectionAlong(position, direction, spread, hit);
#endif
    vec3 radiance = found.rgb;
    for (bool open = found.a < 0.999; open; open = false) radiance += (1.0 - found.a) * skyAt(direction, spread);
    return radiance;
}

struct Reflection {
    vec3 radiance;    // times Fresnel
    float fresnel;
    float swallowed;  // of that, what another wave lets in
};

float firstHit() {
#ifdef REFLECTION
    return hitHere();
#else
    return 0.0;
#endif
}

#ifdef WAVES
// Share of the rays of this rise that meet no other wave.
float clearShare(float rise) {
    return rise > 0.0 ? 1.0 / (1.0 + smithLambda(rise, roughness.w)) : 0.0;
}

// Low rays meet another wave before they reach the sky (Smith's masking by all the sea's slopes); that wave's facets
// lean towards the ray by 1.25 deviations in the mean, and mirror a higher part of the sky in turn.
Reflection reflected(SurfacePoint s, vec3 toEye) {
    VisibleSlopes v = visibleSlopes(s, toEye, 3);
    // From this pixel to the next too; mirroring doubles angles.
    float spread = 2.0 * (v.spread + 0.5 * s.slopeStep);
    Reflection sum = Reflection(vec3(0.0), 0.0, 0.0);
    vec4 again = vec4(0.0);   // mean direction after the second wave, times weight
    float weights = 0.0;
    float hit = firstHit();
    for (int i = 0; i < v.points; ++i) {
        float offset = offsetOf(v, i);
        float weight = weightOf(v, offset);
        vec3 normal = normalOf(s.slope + v.towards * offset);
        vec3 direction = reflect(-toEye, normal);
        float mirrored = weight * fresnelWater(dot(toEye, normal));
        // It bends where few points of the slopes lie: two of their spread's ends are within 3 % of its mean.
        float clear = 0.5 * (clearShare(direction.y - 1.2 * spread) + clearShare(direction.y + 1.2 * spread));
        sum.radiance += mirrored * clear * mirroredRadiance(keptAbove(direction), spread, hit);
        sum.fresnel += mirrored;
        weights += weight;

        vec2 along = direction.xz / max(length(direction.xz), 1e-6);
        vec3 facet = normalOf(along * (1.25 * roughness.w));
        float meets = mirrored * (1.0 - clear);
        float keeps = meets * fresnelWater(dot(-direction, facet));
        again += keeps * vec4(keptAbove(reflect(direction, facet)), 1.0);
        sum.swallowed += meets - keeps;
    }
    for (bool twice = again.w > 1e-3 * sum.fresnel; twice; twice = false)
        sum.radiance += again.w * skyAt(normalize(again.xyz), spread);
    sum.radiance /= weights;
    sum.fresnel /= weights;
    sum.swallowed /= weights;
    return sum;
}
#else
Reflection reflected(SurfacePoint s, vec3 toEye) {
    float hit = firstHit();
    float fresnel = fresnelWater(toEye.y);
    vec3 mirrored = mirroredRadiance(keptAbove(vec3(-toEye.x, toEye.y, -toEye.z)), 0.0, hit);
    return Reflection(fresnel * mirrored, fresnel, 0.0);
}
#endif
