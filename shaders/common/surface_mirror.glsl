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
// Mirrored rays about a direction, as two of half the spread: a cube's mips are as wide across as along, and low rays meet
// another wave where higher ones pass.
struct RayFan {
    vec3 low, high;
    vec2 clear;     // share of each that meets no other wave
    float spread;   // of each [rad, standard deviation]
};

// `axis` is the unit vector along which rays spread most.
RayFan rayFan(vec3 direction, vec3 axis, float along, float across, WavesAhead ahead) {
    RayFan fan;
    fan.spread = max(across, 0.5 * along);
    vec3 aside = sqrt(max(along * along - fan.spread * fan.spread, 0.0)) * axis;
    fan.low = direction - aside;
    fan.high = direction + aside;
    // It bends where few points of the slopes lie: far off two of their spread's ends are within 3 % of its mean.
    vec2 rises = mix(direction.y + 1.2 * along * vec2(-1.0, 1.0), vec2(fan.low.y, fan.high.y), ahead.found);
    fan.clear = vec2(clearShare(rises.x, ahead), clearShare(rises.y, ahead));
    return fan;
}

vec3 clearSky(RayFan fan) {
    vec3 low = fan.clear.x * skyAt(fan.low, fan.spread);
    return 0.5 * (low + fan.clear.y * skyAt(fan.high, fan.spread));
}

// Low rays meet another wave before they reach the sky (Smith's masking by all the sea's slopes); that wave's facets
// lean towards the ray by 1.25 deviations in the mean, and mirror a higher part of the sky in turn.
Reflection reflected(SurfacePoint s, vec3 toEye) {
    VisibleSlopes v = visibleSlopes(s, toEye, 3);
    // From this pixel to the next too; mirroring doubles angles.
    float spread = 2.0 * (v.spread + 0.5 * s.slopeStep);
    float spreadAcross = 2.0 * (deviationAcross(s, v.towards) + 0.5 * s.slopeStep);
    vec3 side = vec3(-v.towards.y, 0.0, v.towards.x);
    Reflection sum = Reflection(vec3(0.0), 0.0, 0.0);
    vec4 again = vec4(0.0);   // mean direction after the second wave, times weight
    float weights = 0.0;
    float hit = firstHit();
    WavesAhead ahead = wavesAhead(s, -v.towards);
    for (int i = 0; i < v.points; ++i) {
        float offset = offsetOf(v, i);
        float weight = weightOf(v, offset);
        vec3 normal = normalOf(s.slope + v.towards * offset);
        vec3 direction = reflect(-toEye, normal);
        float cosine = dot(toEye, normal);
        float mirrored = weight * fresnelWater(cosine);
        // A facet tilted aside turns a ray that grazes it by far less than one tilted to the eye: by cosine.
        RayFan fan = rayFan(direction, cross(side, direction), spread, spreadAcross * cosine, ahead);
        float clear = 0.5 * (fan.clear.x + fan.clear.y);
        vec4 found = mirroredScene(keptAbove(direction), spread, hit);
        sum.radiance += mirrored * clear * found.rgb;
        for (bool open = found.a < 0.999; open; open = false)
            sum.radiance += mirrored * (1.0 - found.a) * clearSky(fan);
        sum.fresnel += mirrored;
        weights += weight;

        vec3 facet = normalOf(horizontal(direction) * (1.25 * roughness.w));
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
    vec3 direction = keptAbove(vec3(-toEye.x, toEye.y, -toEye.z));
    vec4 found = mirroredScene(direction, 0.0, hit);
    vec3 mirrored = found.rgb;
    for (bool open = found.a < 0.999; open; open = false) mirrored += (1.0 - found.a) * skyAt(direction, 0.0);
    return Reflection(fresnel * mirrored, fresnel, 0.0);
}
#endif
