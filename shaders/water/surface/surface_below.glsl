// The surface from within the water: through it the sky and what stands above, in Snell's window; around that, by total
// internal reflection, the water below.
#ifndef SURFACE_BELOW_GLSL
#define SURFACE_BELOW_GLSL

#include "waterline.glsl"
#include "sun_glint.glsl"
#include "water_light.glsl"
#include "surface_mirror.glsl"
#include "refraction.glsl"
#include "underwater_light.glsl"

// Where waves fold, or are seen along their sides, far triangles show in slivers before near ones: from the wrong side. So
// where the line of sight begins has the last word.
bool seenFromBelow(vec2 pixel) {
    return heightAboveSurface(onNearPlane(pixel)) <= 0.0;
}

vec3 keptBelow(vec3 direction) {
    return normalize(vec3(direction.x, min(-abs(direction.y), -1e-3), direction.z));
}

// Whether what the scene shows lies before `at`.
bool hides(Behind b, vec3 at) {
    return !b.nothing && farnessOf(b.seen) < farnessOf(at);
}

// What stands above the water where the ray `along`, in air, meets it in the picture: a walk over the pixels that it is
// seen at, in equal steps, then by halves. Radiance times confidence, and confidence.
vec4 sceneAbove(const SurfacePoint s, vec3 along) {
    const int steps = 16;
    const int halvings = 4;
    const float atContact = 0.1;   // [m]
    vec4 start = homogeneousPixel(s.position);
    vec4 perMetre = homogeneousPerMetre(along);
    if (perMetre.w <= 0.0 && !sightIsParallel()) return vec4(0.0);   // towards the eye's back
    float leaves = perMetre.w > 0.0 ? 0.0 : untilBorder(start, perMetre, vec2(regionSize()));   // of parallel lines, which vanish nowhere
    float reached = 0.0;
    for (int i = 1; i < steps; ++i) {
        float part = float(i) / float(steps);
        float share = part * part;
        float near = reached;
        float far = perMetre.w > 0.0 ? share * start.w / ((1.0 - share) * perMetre.w) : share * leaves;
        reached = far;
        vec4 p = start + far * perMetre;
        if (any(lessThan(p.xy, vec2(0.0))) || any(greaterThanEqual(p.xy, vec2(regionSize()) * p.w))) break;
        Behind found = behindAt(p.xy / p.w);
        if (!hides(found, s.position + far * along)) continue;
        for (int j = 0; j < halvings; ++j) {
            float middle = 0.5 * (near + far);
            vec4 q = start + middle * perMetre;
            Behind b = behindAt(q.xy / q.w);
            if (hides(b, s.position + middle * along)) {
                far = middle;
                found = b;
                p = q;
            } else {
                near = middle;
            }
        }
        // What the ray passes behind is not what it meets, nor is what is in the water, but where it leaves that.
        bool wet = found.seen.y < min(s.position.y, calmLevel()) - atContact;
        if (wet || length(found.seen - s.position - far * along) > 0.05 * far + atContact) continue;
        vec2 pixel = p.xy / p.w;
        vec2 border = min(pixel, vec2(regionSize()) - pixel) / (0.06 * float(regionSize().y));
        float confidence = clamp(min(border.x, border.y), 0.0, 1.0);
        return vec4(radianceOf(found) * confidence, confidence);
    }
    return vec4(0.0);
}

// The sun through the surface, spread by the slopes within the pixel and by its own disc (Walter et al. 2007, eq. 16
// and 21, with n^2 for what refraction gathers).
vec3 sunThrough(const SurfacePoint s, vec3 view) {
    vec3 toSun = sunDirection(s);
    vec3 halfway = waterIndex * view - toSun;
    if (toSun.y <= 0.0 || halfway.y <= 0.0) return vec3(0.0);
    float gap = length(halfway);
    halfway /= gap;
    float cosSun = dot(toSun, halfway);
    float cosEye = dot(view, halfway);
    if (cosSun <= 0.0 || cosEye <= 0.0) return vec3(0.0);
    float density = sunDensity(s, halfway, gap);
    float up2 = halfway.y * halfway.y;
    float seen = visibleArea(visibleSlopes(s, view), view);
    return sunLight(s.sunSeen) * (cosSun * cosEye * waterIndex * waterIndex * (1.0 - mirroredShare(cosSun)) * density /
                                (up2 * up2 * seen * gap * gap));
}

// Up to which offset from their mean slopes let light out of the water along a line of sight: from there on all is mirrored, as
// (up - level slope)^2 = c^2 (1 + aside^2 + slope^2) has it, of the critical angle's cosine c.
float lastWindowSlope(const SurfacePoint s, VisibleSlopes v, vec3 view) {
    const float c2 = 1.0 - 1.0 / (waterIndex * waterIndex);
    float up = view.y, level = length(view.xz);
    float mean = dot(s.slope, v.towards), aside2 = dot(s.slope, s.slope) - mean * mean;
    float k = 1.0 + max(aside2, 0.0);
    float root = sqrt(max(c2 * (up * up + k * (level * level - c2)), 0.0));
    return (up * up - c2 * k) / max(up * level + root, 1e-4) - mean;
}

// Refraction gathers what comes from the sky into the window: radiance grows by n^2.
vec3 throughWindow(const SurfacePoint s, vec3 view, out float reflectance) {
    const float gathered = waterIndex * waterIndex;
    VisibleSlopes v = visibleSlopes(s, view);
    SlopeSteps steps = slopeSteps(v, 7, lastWindowSlope(s, v, view));
    vec3 sum = vec3(0.0);
    reflectance = 1.0;
    int i = 0;
    do {
        float offset = offsetOf(steps, i);
        vec3 normal = normalOf(s.slope + v.towards * offset);
        float cosine = max(dot(view, normal), 1e-4);
        float fresnel = mirroredShareBelow(cosine);
        // Without the second condition Mesa 22.3's llvmpipe may add to the sums of invocations that have left the loop.
        if (fresnel < 1.0 && i < steps.points) {
            float share = shareSeen(steps, v, offset) * (1.0 - fresnel);
            vec3 outward = refract(view, -normal, waterIndex);
            float bends = waterIndex * cosine / max(dot(outward, normal), 0.1) - 1.0;   // of the ray, to the facet's tilt
            float spread = min(bends * (steps.spread + 0.5 * s.slopeStep), 0.5);
            sum += share * skyAt(s, keptAbove(outward), spread);
            reflectance -= share;
        }
    } while (++i < steps.points);
    reflectance = max(reflectance, 0.0);
    vec3 mean = normalOf(s.slope);
    vec3 along = refract(view, -mean, waterIndex);
    if (dot(along, along) > 0.0) {
        vec4 scene = sceneAbove(s, keptAbove(along));
        sum = sum * (1.0 - scene.a) + scene.rgb * (1.0 - reflectance);
    }
    return sum * gathered;
}

// What the host has lit as if in air, `path` metres along a ray into the water from `depth`.
vec3 shownBelow(vec3 toSun, vec3 inAir, float share, float depth, float rise, float path) {
    vec3 lit = litBelow(toSun, inAir, depth - rise * path, 1.0);
    return lit * exp(-extinction() * path) + share * scatteredIn(toSun, depth, rise, path);
}

// A bed so far along the ray, of so much light in air times confidence, and confidence.
vec4 bedAlong(vec3 toSun, vec3 direction, float path, vec4 light, float depth) {
    return vec4(shownBelow(toSun, light.rgb, light.a, depth, direction.y, path), light.a);
}

// Beyond the reflection the bed goes on, as high as where that ends before `pixel`, and of a mean colour, the wider the farther
// out. Radiance times confidence, and confidence.
vec4 bedBeyondReflection(const SurfacePoint s, vec3 direction, vec2 pixel, float depth) {
    vec2 held = heldInRegion(pixel);
    float info = infoAt(held);
    vec3 bed = shownBy(held, info);
    if (!infoIsHit(info) || bed.y > min(s.position.y, calmLevel())) return vec4(0.0);
    float mip = log2(1.0 + 0.5 * inReflectionTexels(length(pixel - held)));
    vec4 light = reflectionAt(held, mip);
    return bedAlong(sunDirection(s), direction, (s.position.y - bed.y) / -direction.y, light, depth);
}

// What the scene's picture shows of the bed.
struct ShownBed {
    vec3 light;
    float height;   // relative to the eye
    float share;    // of the places looked at that show it
    bool stands;    // as what stands on the bed does, whose side is seen
};

bool isBelowEye(const SurfacePoint s, Behind b) {
    return !b.nothing && b.seen.y <= min(0.0, s.position.y);
}

ShownBed shownBedAt(const SurfacePoint s, vec2 pixel) {
    Behind b = behindAt(pixel);
    vec3 step = behindAt(pixel - vec2(0.0, 1.0)).seen - b.seen;
    return ShownBed(radianceOf(b), b.seen.y, isBelowEye(s, b) ? 1.0 : 0.0, abs(step.y) >= 2.0 * length(step.xz));
}

// The mean on a level line about where the picture is `nearest` to a place beyond its border: the longer the farther out, so
// that what is one stone at the border casts no streak, and a bed that ends there ends softly.
ShownBed shownBedBeside(const SurfacePoint s, vec2 pixel, vec2 nearest) {
    const int taps = 5;
    const float offsets[taps] = float[](0.0, -0.6, 0.6, -1.6, 1.6);
    vec4 up = homogeneousPerMetreUp();
    vec2 level = vec2(up.w * nearest.y - up.y, up.x - up.w * nearest.x);
    level *= distance(pixel, nearest) / max(length(level), 1e-9);   // no way is level straight below
    ShownBed mean = ShownBed(vec3(0.0), 0.0, 0.0, false);
    int i = 0;
    [[dont_unroll]] do {
        Behind b = behindAt(nearest + offsets[i] * level);
        if (!isBelowEye(s, b)) continue;
        mean.light += radianceOf(b);
        mean.height += b.seen.y;
        mean.share += 1.0;
    } while (++i < taps);
    float shown = max(mean.share, 1.0);
    return ShownBed(mean.light / shown, mean.height / shown, mean.share / float(taps), false);
}

// As the scene's picture shows the bed nearest to the ray's end, which is sought by turns, from as far as what a flat mirror
// shows here. Where the picture shows no bed there, or what stands before it, the ray ends nearer. `met` where it shows that
// very end.
vec4 bedBeyondScene(const SurfacePoint s, vec3 direction, float depth, out bool met) {
    const float mostOff = 0.03;   // of the ray's length; what stands on the bed lies farther from its end
    float sought = min(hitAt(s.pixel), 1e3);
    float path = sought;
    ShownBed bed = ShownBed(vec3(0.0), 0.0, 0.0, true);
    met = false;
    for (int i = 0; i < 4; ++i) {
        vec4 end = pixelOf(s.position + direction * sought);
        if (end.w <= 0.0) break;
        vec2 nearest = heldInRegion(end.xy);
        bool inside = distance(end.xy, nearest) < 1.0;
        ShownBed there;
        if (inside) there = shownBedAt(s, nearest);
        else there = shownBedBeside(s, end.xy, nearest);
        bool settles = there.share > 0.0 && !there.stands;
        if (!settles && bed.share > 0.0 && !bed.stands) break;
        if (there.share > 0.0) {
            bed = there;
            path = (s.position.y - bed.height) / -direction.y;
        }
        met = inside && settles && abs(path - sought) < mostOff * path;
        sought = settles ? path : sought * (there.share > 0.0 ? 0.5 : 0.2);
    }
    return bedAlong(sunDirection(s), direction, path, vec4(bed.light, 1.0) * bed.share, depth);
}

// What a ray that meets nothing known ends at: a bed that the scene shows there; else the one that is mirrored, which to an eye
// that looks up is all there is; else the one that is seen; else `endless` water.
vec3 bedBeyond(const SurfacePoint s, vec3 direction, vec2 pixel, float depth, vec3 endless) {
    bool met;
    vec4 seen = bedBeyondScene(s, direction, depth, met);
    vec4 bed = met ? seen : bedBeyondReflection(s, direction, pixel, depth);
    bed += (1.0 - bed.a) * seen;
    return bed.rgb + (1.0 - bed.a) * endless;
}

// What a facet mirrors of the water below, and of what lies in it.
vec3 mirroredBy(const SurfacePoint s, vec2 slope, vec3 view, float spread) {
    vec3 direction = keptBelow(reflect(view, normalOf(slope)));
    float depth = max(-s.height, 0.0);
    vec3 radiance = scatteredIn(sunDirection(s), depth, direction.y, endlessPath);
    if (!hasReflection) return radiance;
    BentPoint hit = bentPoint(s.pixel, s.position, direction, hitAt(s.pixel), 2);
    vec4 screen = vec4(0.0);
    float along = hit.distance;
    // From the hit on: a tail found before is followed.
    if (hit.distance < farAway) screen = reflectionAlong(s, direction, spread, along);
    if (screen.a < 0.999 && !infoIsSky(infoAt(hit.pixel))) radiance = bedBeyond(s, direction, hit.pixel, depth, radiance);
    radiance = radiance * (1.0 - screen.a) + shownBelow(sunDirection(s), screen.rgb, screen.a, depth, direction.y, hit.distance);
    return radiance;
}

// For 1, 2 and 4 taps the means of equal shares of a Gaussian [deviations], along the line of sight.
const float belowSamples[7] = float[](0.0, -0.8, 0.8, -1.27, -0.325, 0.325, 1.27);

// Aside each lies to one side or the other, so that along and aside do not depend on each other.
float sideOf(int tap) {
    return tapsPerPixel() == 1 ? 0.0 : (tap & 1) == (tap >> 1) ? 1.0 : -1.0;
}

float sideOfShare() {
    vec2 place = placeInQuad();
    return place.x == place.y ? 1.0 : -1.0;
}

// The mean over the slopes that are seen, at as many of them as there are taps. Seen from below, where no line of sight
// that is mirrored is as low as those over water, slopes turn rays aside as much as up and down: twice reflectionAlong()'s blur.
vec3 mirroredBelowWaves(const SurfacePoint s, vec3 view, inout uint turn) {
    VisibleSlopes v = visibleSlopes(s, view);
    SlopeSpread seen = slopeSpread(v);
    vec2 aside = vec2(-v.towards.y, v.towards.x) * (0.7 * deviationAcross(s, v.towards));
    float spread = 2.0 * tapWidth() * seen.deviation + s.slopeStep;
    float share = sharedInQuad(s, seen, spread, firstHit(s));
    int taps = tapsPerPixel();
    vec3 sum = vec3(0.0);
    int i = 0;
    do {
        float offset = mix(belowSamples[tableRow(i)], dot(levelShares[tableRow(i)], partOfQuad()), share);
        vec2 slope = s.slope + v.towards * (seen.mean + offset * seen.deviation) + aside * mix(sideOf(i), sideOfShare(), share);
        sum += meanFound(vec4(mirroredBy(s, slope, view, spread), 1.0), share, turn).rgb;
    } while (++i < taps);
    return sum / float(taps);
}

vec3 mirroredBelow(const SurfacePoint s, vec3 view, inout uint turn) {
    return hasWaves ? mirroredBelowWaves(s, view, turn) : mirroredBy(s, s.slope, view, s.slopeStep);
}

vec3 shadedBelow(const SurfacePoint s, float foamShare, inout uint turn) {
    vec3 view = normalize(sightTo(s.position));
    float reflectance;
    vec3 radiance = throughWindow(s, view, reflectance);
    radiance += reflectance * mirroredBelow(s, view, turn) + sunThrough(s, view);
    // Foam passes on, spread evenly, what it does not send back.
    if (hasFoam) radiance = mix(radiance, lightEntering(sunDirection(s)) * (1.0 - water.foamAlbedo) / pi, foamShare);
    vec3 start = onNearPlane(s.pixel);
    return throughWater(sunDirection(s), radiance, depthOfSight(start), view.y, max(distanceTo(s.position) - distanceTo(start), 0.0));
}

#endif
