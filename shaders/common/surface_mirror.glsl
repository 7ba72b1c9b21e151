// What the surface mirrors: an integral over the slopes that the eye can see, along the line of sight, each with its own
// Fresnel term and weighted by its visible area. Without it the mean normal makes the far sea a mirror of the horizon.
//
// Loops of one round stand for branches: CPU devices leave them out where nobody is in them.

#ifdef REFLECTION
#include "reflection_lookup.glsl"
#endif

// `spread` is the standard deviation of the mirrored direction [rad]. A texel of a cube's mip, read linearly, spreads by
// 0.65 of its width where each mip is a smooth half of the last (by 0.5 after a box), and is 2 / edge wide amid a face.
vec3 skyAt(vec3 direction, float spread) {
    vec3 size = abs(direction);
    float texel = 2.0 * max(max(size.x, size.y), size.z) / exp2(skyMips - 1.0);
    float mip = clamp(log2(max(spread / (0.65 * texel), 1.0)), 0.0, max(skyMips - 2.0, 0.0));
    // No mirrored ray comes from below the horizon, so neither may the blur.
    return textureLod(skyCube, vec3(direction.x, max(direction.y, spread), direction.z), mip).rgb;
}

vec3 keptAbove(vec3 direction) {
    return normalize(vec3(direction.x, max(abs(direction.y), 1e-3), direction.z));
}

struct Reflection {
    vec3 radiance;    // times Fresnel
    float fresnel;
    float swallowed;  // of that, what another wave lets in
};

// Of the scene, times confidence, and confidence. `hit` is how far away the last ray beside this one met something [m].
vec4 mirroredScene(vec3 direction, float spread, inout float hit) {
#ifdef REFLECTION
    return reflectionAlong(position, direction, spread, hit);
#else
    return vec4(0.0);
#endif
}

float firstHit() {
#ifdef REFLECTION
    return hitHere();
#else
    return 0.0;
#endif
}

#ifdef WAVES
// The slopes that the eye sees are four: two in each half, for which the scene and the sky are looked up as one. Low rays
// meet another wave before they reach the sky (Smith's masking by all the sea's slopes); that wave's facets lean towards
// the ray by 1.25 deviations in the mean, and mirror a higher part of the sky in turn.
Reflection reflected(SurfacePoint s, vec3 toEye) {
    const vec2 offsets = vec2(0.7875, 2.2);   // from the mean, in deviations: nearly Gauss and Hermite's
    const vec2 shares = vec2(0.455, 0.045);
    VisibleSlopes v = visibleSlopes(s, toEye);
    SlopeSpread seen = slopeSpread(v);
    // Of each half, and from this pixel to the next; mirroring doubles angles.
    float spread = seen.deviation + s.slopeStep;
    // A facet tilted aside turns a ray that grazes it by far less than one tilted to the eye: by cosine.
    float cosine = dot(toEye, normalOf(s.slope + v.towards * seen.mean));
    float spreadOfSky = max((2.0 * deviationAcross(s, v.towards) + s.slopeStep) * cosine, 0.5 * spread);
    Reflection sum = Reflection(vec3(0.0), 0.0, 0.0);
    vec4 met = vec4(0.0);   // rays that meet another wave, times their weight, and that
    float hit = firstHit();
    WavesAhead ahead = wavesAhead(s, -v.towards);
    for (int side = -1; side <= 1; side += 2) {
        vec4 all = vec4(0.0);
        vec4 clear = vec4(0.0);   // rays that meet none
        for (int i = 0; i < 2; ++i) {
            vec3 normal = normalOf(s.slope + v.towards * (seen.mean + float(side) * offsets[i] * seen.deviation));
            vec3 direction = reflect(-toEye, normal);
            vec4 mirrored = shares[i] * fresnelWater(dot(toEye, normal)) * vec4(direction, 1.0);
            all += mirrored;
            clear += clearShare(direction.y, ahead) * mirrored;
        }
        vec4 found = mirroredScene(keptAbove(all.xyz), spread, hit);
        sum.radiance += clear.w * found.rgb;
        for (bool open = found.a < 0.999 && clear.w > 1e-6; open; open = false)
            sum.radiance += clear.w * (1.0 - found.a) * skyAt(clear.xyz / clear.w, spreadOfSky);
        sum.fresnel += all.w;
        met += all - clear;
    }
    for (bool again = met.w > 1e-3 * sum.fresnel; again; again = false) {
        vec3 direction = normalize(met.xyz);
        vec3 facet = normalOf(horizontal(direction) * (1.25 * roughness.w));
        float keeps = met.w * fresnelWater(dot(-direction, facet));
        sum.radiance += keeps * skyAt(keptAbove(reflect(direction, facet)), spread);
        sum.swallowed = met.w - keeps;
    }
    return sum;
}
#else
Reflection reflected(SurfacePoint s, vec3 toEye) {
    float hit = firstHit();
    float fresnel = fresnelWater(toEye.y);
    vec3 direction = keptAbove(vec3(-toEye.x, toEye.y, -toEye.z));
    vec4 found = mirroredScene(direction, 0.0, hit);
    vec3 mirrored = found.rgb;
    for (bool open = found.a < 0.999; open; open = false) mirrored += (1.0 - found.a) * skyAt(direction, 0.0);
    return Reflection(fresnel * mirrored, fresnel, 0.0);
}
#endif
