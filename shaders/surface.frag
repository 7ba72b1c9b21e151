// Shades the water's surface: what it mirrors, what shines through, the sun's glint and foam.
//
// The sub-pixel part of the waves is a Gaussian of slopes (Cox and Munk 1954): its variance is what the mips of the
// derivatives lost plus what no cascade holds. Reflection integrates over the slopes that the eye can see, along the line
// of sight, each with its own Fresnel term and weighted by its visible area; without that, the mean normal makes the far
// sea a mirror of the horizon.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
#include "optics.glsl"

layout(location = 0) in vec2 calmPosition;
layout(location = 1) in vec3 position;
layout(location = 0) out vec4 outColor;

layout(constant_id = 0) const uint surfaceOutput = 0;
const uint outputShaded = 0;
const uint outputReflection = 1;
const uint outputClass = 2;
const uint outputHeight = 3;
const uint outputNormal = 4;
const uint outputFoam = 5;
const uint outputReflectionSource = 6;
const uint outputSlopes = 7;

struct SurfacePoint {
    vec2 slope;        // mean over the pixel
    vec3 covariance;   // of the slopes within it: uu, vv, uv
    float slopeStep;   // change of slope to the next pixel
};

#ifdef WAVES
float jacobianOf(vec4 derivatives, float shear) {
    return (1.0 + derivatives.z) * (1.0 + derivatives.w) - shear * shear;
}
#endif

SurfacePoint surfacePoint() {
    SurfacePoint s = SurfacePoint(vec2(0.0), roughness.xyz, 0.0);
#ifdef WAVES
    vec4 derivatives = vec4(0.0);
    float shear = 0.0;
    vec3 variance = vec3(0.0);
    for (int i = 0; i < cascades; ++i) {
        vec3 at = vec3(cascade[i].xy + calmPosition * cascade[i].z, i);
        vec4 d = texture(waveDerivatives, at);
        derivatives += d;
        shear += texture(waveDisplacement, at).w;
        variance += texture(waveMoments, at).xyz - vec3(d.xy * d.xy, d.x * d.y);
    }
    variance.xy = max(variance.xy, 0.0);
    // Tangents (1 + dDx/du, dh/du, shear) and (shear, dh/dv, 1 + dDz/dv); their cross product is the normal.
    vec2 diagonal = 1.0 + derivatives.zw;
    vec2 bent = vec2(derivatives.x * diagonal.y - derivatives.y * shear, derivatives.y * diagonal.x - derivatives.x * shear);
    // Where the surface folds the Jacobian passes zero and the slope is vertical.
    s.slope = bent / max(jacobianOf(derivatives, shear), 0.15);
    s.covariance += variance;
    vec2 change = max(abs(dFdx(s.slope)), abs(dFdy(s.slope)));
    s.slopeStep = max(change.x, change.y);
#endif
    return s;
}

vec3 normalOf(vec2 slope) {
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

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

// Radiance of the sun's mirror image, spread by the slopes within the pixel (Bruneton, Neyret and Holzschuch 2010,
// eq. 14), the sun's own disc included in the variance.
vec3 sunGlint(SurfacePoint s, vec3 toEye) {
    const float discVariance = 5.4e-6;
    vec3 halfway = normalize(toEye + toSun.xyz);
    if (toSun.y <= 0.0 || halfway.y <= 0.0) return vec3(0.0);
    vec2 slope = -halfway.xz / halfway.y;
    float density = slopeDensity(slope - s.slope, s.covariance + vec3(discVariance, discVariance, 0.0));
    float fresnel = fresnelWater(dot(toEye, halfway));
    vec3 normal = normalOf(s.slope);
    float cosEye = max(dot(toEye, normal), 1e-3);
    float deviation = sqrt(0.5 * (s.covariance.x + s.covariance.y));
    float masking = 1.0 + smithLambda(cosEye, deviation) + smithLambda(max(toSun.y, 1e-3), roughness.w);
    float up2 = halfway.y * halfway.y;
    return sunIrradiance.rgb * (fresnel * density / (4.0 * up2 * up2 * cosEye * masking));
}

// Light scattered back by the water itself along `path` metres, as seen above the surface. The irradiance reflectance
// of deep water is 0.33 bb/a (Morel and Prieur 1977); leaving water thins radiance by n^2 and what Fresnel keeps.
vec3 waterGlow(vec3 path) {
    vec3 a = max(absorption.rgb, 1e-5);
    vec3 reflectance = 0.33 * backscatter.rgb / (a + backscatter.rgb);
    float sunEnters = max(toSun.y, 0.0) * (1.0 - fresnelWater(max(toSun.y, 0.0)));
    const float skyEnters = 0.934;   // 1 - 0.066, diffuse Fresnel reflectance of water
    vec3 down = sunIrradiance.rgb * sunEnters + skyIrradiance.rgb * skyEnters;
    const float leaves = 0.98 / (waterIndex * waterIndex);
    // Light goes down about as far as it comes back.
    return down / pi * reflectance * leaves * (1.0 - exp(-2.0 * (a + backscatter.rgb) * path));
}

#ifdef REFRACTION
struct Behind {
    vec3 radiance;
    vec3 seen;     // where, relative to the eye
    bool nothing;  // but the far plane
};

// What the host's opaque scene shows at a pixel of the region.
Behind behindAt(vec2 pixel) {
    ivec2 p = clamp(ivec2(pixel), ivec2(0), region.zw - 1);
    float depth = texelFetch(sceneDepth, region.xy + p, 0).r;
    Behind b = Behind(vec3(0.0), vec3(0.0), depthSign * (depth - farDepth) <= 0.0);
    if (b.nothing) return b;
    vec4 q = relativeFromPixel * vec4(vec2(p) + 0.5, depth, 1.0);
    b.seen = q.xyz / q.w;
    b.radiance = texelFetch(sceneColor, region.xy + p, 0).rgb;
    return b;
}

// As much of a shift as the picture has room for: nearly all of a small one, and at most half the way to the border, so
// that what lies there is stretched no more than twice.
vec2 keptInside(vec2 from, vec2 shift) {
    vec2 room = max(mix(from, vec2(region.zw) - from, step(0.0, shift)), vec2(1e-3));
    vec2 share = 2.0 * shift / room;
    return shift * inversesqrt(1.0 + max(share.x * share.x, share.y * share.y));
}

// What shines through, along the ray that Snell's law bends: it is steeper than the line of sight, so the bed looks
// raised and little water lies before it. The bent ray's end is taken as deep as what was seen last, and looked up
// where it projects; what stands out of the water there is passed over.
vec3 refracted(vec3 normal, vec3 toEye) {
    const float shallowest = 0.1;
    vec2 here = gl_FragCoord.xy - vec2(region.xy);
    Behind found = behindAt(here);
    if (found.nothing) return waterGlow(vec3(1e6));
    vec3 bent = refract(-toEye, normal, 1.0 / waterIndex);
    float steepness = max(-bent.y, shallowest);
    float drop = max(position.y - found.seen.y, 0.0);
    for (int i = 0; i < 2; ++i) {
        vec4 target = pixelOf(position + bent * (drop / steepness));
        Behind b = behindAt(here + keptInside(here, (target.xy - here) * refractionDistortion));
        bool below = !b.nothing && target.w > 0.0 && b.seen.y < min(position.y, -plane.w);
        if (!below) continue;
        found = b;
        drop = position.y - b.seen.y;
    }
    float path = mix(length(found.seen - position), drop / steepness, refractionDistortion);
    float depth = max(-(found.seen.y + plane.w), 0.0);
    // The host lit what lies below as if in air: the way down dims it once more.
    vec3 through = exp(-(absorption.rgb + backscatter.rgb) * (path + depth));
    return found.radiance * through + waterGlow(vec3(path));
}
#else
vec3 refracted(vec3 normal, vec3 toEye) {
    return waterGlow(vec3(1e6));
}
#endif

#ifdef FOAM
const float foamTile = 24.0;   // [m], as in water/surface.h

// Share of the surface that is white: what each cascade's breakers left (water/foam_history.h).
float foamCover() {
    float clear = 1.0;
    for (int i = 0; i < foamCascades; ++i) {
        vec2 steps = texture(foamHistory, vec3(cascade[i].xy + calmPosition * cascade[i].z, i)).rg;
        clear *= 1.0 - mix(steps.x, steps.y, foam.x);
    }
    return 1.0 - clear;
}

// How much of an octave of the pattern a pixel still shows; the rest is its mean.
float octaveShown(float tile, float pixelWidth) {
    const float patternSamples = 256.0;
    return 1.0 - clamp(0.5 * log2(max(pixelWidth * patternSamples / tile, 1.0)), 0.0, 1.0);
}

// Cover breaks up into rafts and lace where they can be seen, and is a mean where they cannot: white is a share `cover`
// of the surface either way.
float foamMask(float cover) {
    const vec3 weights = vec3(0.35, 0.4, 0.25);
    const vec3 tiles = foamTile / vec3(1.0, 5.0, 17.0);
    vec2 stepSize = max(abs(dFdx(calmPosition)), abs(dFdy(calmPosition)));
    float pixelWidth = max(stepSize.x, stepSize.y);
    float pattern = 0.0;
    float variance = 1e-5;
    for (int i = 0; i < 3; ++i) {
        float weight = weights[i] * octaveShown(tiles[i], pixelWidth);
        pattern += weight * (texture(foamPattern, (foam.zw + calmPosition) / tiles[i]).r - 0.5);
        variance += weight * weight / 12.0;   // of an even distribution
    }
    // The octaves' sum is nearly normal; as its own distribution function it is even again, so that a share `cover` of
    // it lies below `cover`.
    float even = 1.0 / (1.0 + exp(-1.702 * pattern * inversesqrt(variance)));
    float edge = min(0.12, 0.5 * min(cover, 1.0 - cover)) + 1e-4;
    float rafts = smoothstep(-edge, edge, cover - even);
    return mix(cover, rafts, clamp(variance / 0.008, 0.0, 1.0));
}

vec3 withFoam(vec3 water, float mask, vec3 normal) {
    vec3 light = sunIrradiance.rgb * max(dot(normal, toSun.xyz), 0.0) + skyIrradiance.rgb;
    return mix(water, light * foam.y / pi, mask);
}
#endif

vec4 debugOutput(SurfacePoint s, vec3 normal, vec3 toEye) {
    if (surfaceOutput == outputHeight) return vec4(position.y + plane.w, 0.0, 0.0, 1.0);
    if (surfaceOutput == outputNormal) return vec4(normal, 1.0);
    if (surfaceOutput == outputSlopes) return vec4(s.slope, s.covariance.xy);
#ifdef FOAM
    if (surfaceOutput == outputFoam) return vec4(foamMask(foamCover()), 0.0, 0.0, 1.0);
#endif
#ifdef REFLECTION
    if (surfaceOutput == outputClass) return vec4(classColor(position, keptAbove(reflect(-toEye, normal))), 1.0);
#endif
    if (surfaceOutput == outputReflectionSource) {
#ifdef REFLECTION
        return reflectionSource(position, keptAbove(reflect(-toEye, normal)));
#else
        return vec4(-1.0, -1.0, 0.0, 1.0);   // the sky
#endif
    }
    if (surfaceOutput == outputReflection) {
        Reflection r = reflected(s, toEye);
        return vec4(r.radiance / max(r.fresnel, 1e-4), 1.0);
    }
    return vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
    // Of millions of pixels lavapipe gives the odd one to a triangle without area, with NaN for a depth.
    if (!(gl_FragCoord.z > 0.0 && gl_FragCoord.z < 1.0)) discard;
    SurfacePoint s = surfacePoint();
    vec3 toEye = -normalize(position);
    vec3 normal = normalOf(s.slope);
    if (surfaceOutput != outputShaded) {
        outColor = debugOutput(s, normal, toEye);
        return;
    }
    Reflection mirror = reflected(s, toEye);
    vec3 radiance = mirror.radiance + (1.0 - mirror.fresnel) * refracted(normal, toEye) + sunGlint(s, toEye);
#ifdef FOAM
    radiance = withFoam(radiance, foamMask(foamCover()), normal);
#endif
    outColor = vec4(radiance, 1.0);
}
