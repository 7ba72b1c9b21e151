// What the surface mirrors: an integral over the slopes that the eye can see, along the line of sight, each with its own
// Fresnel term and weighted by its visible area. Without it the mean normal makes the far sea a mirror of the horizon.
#ifndef SURFACE_MIRROR_GLSL
#define SURFACE_MIRROR_GLSL

#include "in_world.glsl"
#include "sky_seen.glsl"
#include "surface_fog.glsl"
#include "visible_slopes.glsl"
#include "surface_fresnel.glsl"
#include "waves_ahead.glsl"
#include "reflection_lookup.glsl"

// `spread` is the standard deviation of the mirrored direction [rad]. A texel of a cube's mip, read linearly, spreads by
// 0.65 of its width where each mip is a smooth half of the last (by 0.5 after a box), and is 2 / edge wide amid a face.
vec3 skyAt(const SurfacePoint s, vec3 direction, float spread) {
    // No mirrored ray comes from below the plane, so neither may the blur.
    vec3 kept = inWorld(vec3(direction.x, max(direction.y, spread), direction.z));
    if (skyHasColors) return foggedSky(skyOfColors(kept, spread), s.overPlane, direction);
    vec3 size = abs(inWorld(direction));
    float mips = cubeMips();
    float texel = 2.0 * max(max(size.x, size.y), size.z) / exp2(mips - 1.0);
    float mip = clamp(log2(max(spread / (0.65 * texel), 1.0)), 0.0, max(mips - 2.0, 0.0));
    return foggedSky(cubeAt(kept, mip), s.overPlane, direction);
}

// Without a blur.
vec3 skyAlong(const SurfacePoint s, vec3 direction) {
    if (skyHasColors) return foggedSky(skyOfColors(inWorld(direction), 0.0), s.overPlane, direction);
    return foggedSky(cubeAt(inWorld(direction), 0.0), s.overPlane, direction);
}

vec3 keptAbove(vec3 direction) {
    return normalize(vec3(direction.x, max(abs(direction.y), 1e-3), direction.z));
}

struct Reflection {
    vec3 radiance;    // times Fresnel, through the air before it
    float fresnel;
    float swallowed;  // of that, what another wave lets in
};

// Of the scene, times confidence, and confidence. `hit` is how far away the last ray beside this one met something [m].
vec4 mirroredScene(const SurfacePoint s, vec3 direction, float spread, inout float hit) {
    if (!hasReflection) return vec4(0.0);
    vec3 along = fromLevel(s, direction);
    vec4 found = reflectionAlong(s, along, spread, hit);
    if (hasShore && hasRefraction) {
        float shallow = 1.0 - deepEnough(s.shore);
        if (shallow > 0.0) found += (1.0 - found.a) * shallow * mirroredOverSand(s, along);
    }
    return found;
}

float texelsBlurred(const SurfacePoint s, float spread, float hit) {
    return hasReflection ? blurTexels(s.position, spread, hit) : 0.0;
}

float firstHit(const SurfacePoint s) {
    return hasReflection ? hitAt(s.pixel) : 0.0;
}

// The slopes that the eye sees, as offsets from their mean in deviations, of a Gaussian and of Rayleigh's distribution: four,
// nearly Gauss and Hermite's, for the lopsided fitted to keep the mean, the deviation and, within 2 %, Fresnel's
// mean; or the means of eight equal shares, which tell edges better apart. None of them is seen from behind.
const int slopesSeen = reflectionSamples == 4 ? 8 : 4;
const vec4 fourLevel = vec4(-2.2, -0.7875, 0.7875, 2.2);
const vec4 fourEdgeOn = vec4(-2.85, -0.68, 0.78, 1.8);
const vec4 fourShares = vec4(0.045, 0.455, 0.455, 0.045);
const vec4 eightLevel[2] = vec4[](vec4(-1.694, -0.921, -0.505, -0.162), vec4(0.162, 0.505, 0.921, 1.694));
const vec4 eightEdgeOn[2] = vec4[](vec4(-1.884, -0.916, -0.431, -0.053), vec4(0.283, 0.609, 0.959, 1.433));

float slopeSeen(int i, SlopeSpread seen) {
    vec4 level = fourLevel, edgeOn = fourEdgeOn;
    if (reflectionSamples == 4) {
        level = i < 4 ? eightLevel[0] : eightLevel[1];
        edgeOn = i < 4 ? eightEdgeOn[0] : eightEdgeOn[1];
    }
    return seen.mean + mix(level[i & 3], edgeOn[i & 3], seen.skew) * seen.deviation;
}

float shareOfSlope(int i) {
    return reflectionSamples == 4 ? 0.125 : fourShares[i & 3];
}

int tapsPerPixel() {
    return reflectionSamples;
}

// In tables for one tap, two and four.
int tableRow(int tap) {
    return reflectionSamples - 1 + tap;
}

// For one tap, two and four, the means of four equal shares of each one's slopes.
const vec4 levelShares[7] = vec4[](
    vec4(-1.370, -0.350, 0.350, 1.370),
    vec4(-1.694, -0.921, -0.505, -0.163), vec4(0.163, 0.505, 0.921, 1.694),
    vec4(-1.990, -1.341, -1.024, -0.787), vec4(-0.587, -0.407, -0.240, -0.079),
    vec4(0.079, 0.240, 0.407, 0.587), vec4(0.787, 1.024, 1.341, 1.990));
const vec4 edgeOnShares[7] = vec4[](
    vec4(-1.466, -0.253, 0.467, 1.252),
    vec4(-1.884, -0.916, -0.430, -0.053), vec4(0.283, 0.609, 0.959, 1.433),
    vec4(-2.273, -1.434, -1.043, -0.758), vec4(-0.525, -0.322, -0.138, 0.034),
    vec4(0.198, 0.358, 0.518, 0.680), vec4(0.850, 1.036, 1.252, 1.567));

// The slope that stands for this pixel's share of a tap's, as an offset from what is in the middle of the pixel.
float slopeOfShare(int tap, SlopeSpread seen) {
    int shares = tableRow(tap);
    return seen.mean + dot(mix(levelShares[shares], edgeOnShares[shares], seen.skew), partOfQuad()) * seen.deviation;
}

// Few taps of a window in rough water show as many windows, not the column that it makes. So the pixels of a quad look at
// shares of the slopes each, and take the mean of what they find. How far they do so [0..1]: not where the quad's slopes
// differ by more than those within a pixel, nor where what they mirror lies within a texel or so.
float sharedInQuad(const SurfacePoint s, SlopeSpread seen, float spread, float hit) {
    float blurred = smoothstep(1.0, 3.0, seen.deviation / max(s.slopeStep, 1e-6)) * smoothstep(0.1, 0.2, texelsBlurred(s, spread, hit));
    return s.quadIsAlike ? blurred : 0.0;
}

// The more of the mean where they share in part, or what each found for itself would stand out as a pattern of dots.
vec4 meanFound(vec4 own, float share, inout uint turn) {
    vec4 mean = meanOfQuad(own, turn);
    return share > 0.0 ? mix(own, mean, share * (2.0 - share)) : own;
}

// Deviation of the mirrored directions that one tap stands for, in those of all slopes: mirroring doubles angles.
float tapWidth() {
    return reflectionSamples == 1 ? 1.7 : reflectionSamples == 2 ? 1.0 : 0.5;
}

// Of a tap's spread, what the sky is blurred by at the least. Slopes spread rays up and down, but a cube's mips blur alike in
// all directions: by more, the glow around a low sun would show far to its sides. Fewer taps need more, or they show as such.
const float skyBlurred = reflectionSamples == 4 ? 0.35 : 0.5;

// What a ray meets of another wave: of the facets that show themselves to it, which rises, the one that mirrors as much as
// they do in the mean. It leans by a third of a deviation less than their mean, by which Fresnel's term is off by 0.035 at
// most, for seas whose slopes deviate by 0.1 to 0.35.
vec3 facetMet(vec3 ray) {
    VisibleSlopes v = VisibleSlopes(horizontal(-ray), max(slopeDeviation(), 1e-5), -ray.y / max(length(ray.xz), 1e-6));
    SlopeSpread met = slopeSpread(v);
    return normalOf(v.towards * (met.mean + met.deviation / 3.0));
}

// A sample of the sky: what it counts for, and the deviation of its rays [rad].
struct SkySample {
    vec3 towards;
    float spread, weight;
};

// Of rays that meet other waves, times their weight, and that: these mirror a higher part of the sky, or what the last tap `found`.
SkySample skyOfMet(vec4 met, vec4 found, float spread, inout Reflection sum) {
    vec3 direction = normalize(met.xyz);
    vec3 facet = facetMet(direction);
    float keeps = met.w * mirroredShare(dot(-direction, facet));
    sum.swallowed = met.w - keeps;
    sum.radiance += keeps * found.rgb;
    return SkySample(keptAbove(reflect(direction, facet)), spread, keeps * (1.0 - found.a));
}

// The scene and the sky are looked up in as many groups of neighbouring slopes as there are taps. Low rays meet another wave
// before they reach the sky (Smith's masking by all the sea's slopes), which mirrors a higher part of it in turn, or of what
// the last tap found.
vec3 sightAlong(vec2 towards, float rise) {
    float level = sqrt(max(1.0 - rise * rise, 0.0));
    return vec3(level * towards.x, rise, level * towards.y);
}

Reflection reflectedByWaves(const SurfacePoint s, vec3 toEye, inout uint turn) {
    const int together = slopesSeen / reflectionSamples;
    VisibleSlopes v = visibleSlopes(s, toEye);
    float spreadAside = 2.0 * deviationAcross(s, v.towards) + s.slopeStep;
    Reflection sum = Reflection(vec3(0.0), 0.0, 0.0);
    vec4 met = vec4(0.0);   // rays that meet another wave, times their weight, and that
    vec4 found = vec4(0.0);
    float hit = firstHit(s);
    WavesAhead ahead = wavesAhead(s, -v.towards, 0.0);
    float rise = toEye.y;
    int tap = 0;
    [[dont_unroll]] do {
        SlopeSpread seen = slopeSpread(v);
        float spread = tapWidth() * seen.deviation + s.slopeStep;   // and from this pixel to the next
        toEye = sightAlong(v.towards, rise);
        vec4 total = vec4(0.0);
        vec4 clear = vec4(0.0);   // rays that meet none
        float cosines = 0.0;
        int j = 0;
        [[dont_unroll]] do {
            int i = tap * together + j;
            vec2 slope = s.slope + v.towards * slopeSeen(i, seen);
            vec3 normal = normalOf(slope);
            vec3 direction = reflect(-toEye, normal);
            float cosine = dot(toEye, normal);
            vec4 mirrored = shareOfSlope(i) * mirroredShare(cosine) * vec4(direction, 1.0);
            total += mirrored;
            cosines += mirrored.w * max(cosine, 0.0);
            clear += clearShare(direction.y, -dot(slope, v.towards), ahead) * mirrored;
        } while (++j < together);
        sum.fresnel += total.w;
        met += total - clear;
        SkySample sky = SkySample(clear.xyz / max(clear.w, 1e-6), max(spreadAside * cosines / max(total.w, 1e-6), skyBlurred * spread), clear.w);
        float share = sharedInQuad(s, seen, spread, hit);
        vec3 ofShare = reflect(-toEye, normalOf(s.slope + v.towards * slopeOfShare(tap, seen)));
        vec3 ray = keptAbove(mix(total.xyz / max(total.w, 1e-6), ofShare, share));
        if (hasReflection) found = meanFound(mirroredScene(s, ray, spread, hit), share, turn);
        if (hasReflection) found.rgb = sceneThroughAir(found.rgb, vec3(found.a), s.air);
        sum.radiance += sky.weight * found.rgb;
        sky.weight = found.a < 0.999 && sky.weight > 1e-6 ? sky.weight * (1.0 - found.a) : 0.0;
        bool meets = tap + 1 == reflectionSamples && met.w > 1e-3 * sum.fresnel;
        int part = 0;
        // What rays meet of other waves mirrors sky too, by the same copy of the code.
        [[dont_unroll]] do {
            if (sky.weight > 0.0) sum.radiance += sky.weight * throughAir(skyAt(s, sky.towards, sky.spread), s.air);
            if (meets && part == 0) sky = skyOfMet(met, found, 0.5 * spread, sum);
        } while (++part < (meets ? 2 : 1));
    } while (++tap < reflectionSamples);
    return sum;
}

Reflection reflectedByStillWater(const SurfacePoint s, vec3 toEye) {
    float hit = firstHit(s);
    float fresnel = mirroredShare(toEye.y);
    vec3 direction = keptAbove(vec3(-toEye.x, toEye.y, -toEye.z));
    vec4 found = mirroredScene(s, direction, 0.0, hit);
    vec3 mirrored = sceneThroughAir(found.rgb, vec3(found.a), s.air);
    if (found.a < 0.999) mirrored += (1.0 - found.a) * throughAir(skyAlong(s, direction), s.air);
    return Reflection(fresnel * mirrored, fresnel, 0.0);
}

Reflection reflected(const SurfacePoint s, vec3 toEye, inout uint turn) {
    return hasWaves ? reflectedByWaves(s, toEye, turn) : reflectedByStillWater(s, toEye);
}

#endif
