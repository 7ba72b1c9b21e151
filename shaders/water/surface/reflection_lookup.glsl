// Looks up a reflection image along a ray that waves have bent.
//
// A point at distance t along the ray is mirrored about the plane and projected: the reflection image holds there what
// the flat mirror shows of it. t comes from the image itself, so the shift vanishes where things touch the water and
// grows with their distance; a constant offset would tear shorelines.
#ifndef REFLECTION_LOOKUP_GLSL
#define REFLECTION_LOOKUP_GLSL

#include "surface_point.glsl"
#include "surface.glsl"
#include "reflection_info.glsl"
#include "reflection_source.glsl"
#include "reflection_blur.glsl"
#include "reflection_texels.glsl"
#include "scene_behind.glsl"

const float farAway = 1e5;
const float endlesslyFar = 1e9;   // the eye of parallel lines of sight [m]

// A ray from a trough may meet what stands there lower than the mirror's plane: the image begins with what is just above that.
vec2 mirroredPixel(vec3 from, vec3 direction, float t) {
    vec3 p = from + direction * t;
    float above = p.y + water.mirror.x;
    if (hasWaves && direction.y > 0.0) above = max(above, clamp(-water.mirror.x - from.y, 0.0, 2.5 * water.reflectionScale * pixelWidth(from)));
    p.y = -water.mirror.x - above;
    vec4 pixel = pixelOf(p);
    // Behind the camera: outside of every image.
    return pixel.w > 0.0 ? pixel.xy : vec2(-1e4);
}

float inReflectionTexels(float pixels) {
    return pixels / water.reflectionScale;
}

// At a pixel of the region.
vec4 reflectionAt(vec2 pixel, float mip) {
    return reflectionTexel(reflectionColor, reflectionInfo, pixel / water.reflectionScale, mip, water.reflectionScale);
}

float infoAt(vec2 pixel) {
    bool inside = inRegion(pixel);
    return inside ? texelFetch(reflectionInfo, ivec2(pixel / water.reflectionScale), 0).x : infoUnknown;
}

struct BentPoint {
    vec2 pixel;
    float distance;   // to the hit [m], farAway for the sky
};

// How far away what a flat mirror shows at a pixel is [m].
float hitAt(vec2 pixel) {
    float info = infoAt(pixel);
    return infoIsHit(info) ? info : farAway;
}

Ray rayThrough(vec2 pixel) {
    vec3 at = pointAt(pixel, 0.5);
    return Ray(sightStart(at), normalize(sightTo(at)));
}

// What the image shows at a pixel, of which `info` is known.
vec3 shownBy(vec2 pixel, float info) {
    Ray ray = rayThrough(pixel);
    return mirroredPoint(ray, ray, info, calmNormal(), water.mirror.x);
}

// How far along the ray what the image shows at a pixel lies [m], of which `info` is known, else `t`. Not what `info` says: another place
// of the mirror shows it, which on steep waves may be far nearer to it. Into the water it does: rays to a level bed are as long from
// place to place, and points of it run away along them.
float towardsShown(vec3 from, vec3 direction, vec2 pixel, float info, float t) {
    if (!infoIsHit(info)) return t;
    if (direction.y < 0.0) return info;
    float along = dot(shownBy(pixel, info) - from, direction);
    return along > 0.0 ? along : t;
}

// What stands before water hides in the mirror what rays from that water meet: a boat's side, as it is mirrored on this side
// of it. Then what is shown half as far away from the pixel, or in it, stands for what is hidden.
BentPoint aheadOf(vec2 here, vec3 from, vec3 direction, BentPoint point) {
    const float leastCosine = 0.5;   // of the angle between the ray and the way to what it is said to meet
    if (direction.y < 0.0) return point;
    int i = 0;
    [[dont_unroll]] do {
        float info = infoAt(point.pixel);
        vec3 way = shownBy(point.pixel, info) - from;
        float along = dot(way, direction);
        if (i > 0 && infoIsHit(info) && along > 0.0) point.distance = min(point.distance, along);
        if (i == 2 || !infoIsHit(info) || along > leastCosine * length(way)) break;
        point.pixel = i == 0 ? mix(here, point.pixel, 0.5) : here;
    } while (++i < 3);
    return point;
}

// Of the way from a pixel to where its bent ray vanishes: two thirds as far along as the eye is away.
const float overNear = 0.4;

// The pixel whose reflection the bent ray meets, by `rounds` of fixed-point iteration on how far what is shown there lies
// along the ray, from `t`. `here` is the pixel that the ray leaves the water at. One that starts at the sky jumps over what is near, such as the tail of a buoy's reflection: a
// last round is for that.
BentPoint bentPoint(vec2 here, vec3 from, vec3 direction, float t, int rounds) {
    if (!hasWaves) return BentPoint(here, t);
    // From a trough what a flat mirror shows here lies nearer than it is to that mirror: so near that the image may end before.
    bool inTrough = direction.y > 0.0 && from.y < -water.mirror.x && t < farAway;
    bool fromHere = false;
    vec2 pixel = here;
    float nearer = t;
    int last = rounds, i = 0;
    // All rounds share one copy of the code.
    [[dont_unroll]] do {
        vec2 met = mirroredPixel(from, direction, nearer);
        if (fromHere) met = here;
        fromHere = false;
        if (i <= last) {
            pixel = met;
            t = nearer;
        }
        if (i == last && t < farAway) break;
        vec2 sought = i == last ? mix(here, met, overNear) : met;
        float info = infoAt(sought);
        if (i > last) {
            if (nearer < t && infoIsHit(info)) {
                pixel = met;
                t = nearer;
            }
            break;
        }
        fromHere = i == 0 && inTrough && inRegion(met) && !infoIsHit(info);
        if (fromHere) last += 2;
        else nearer = towardsShown(from, direction, sought, info, t);
    } while (++i < rounds + 4);
    return aheadOf(here, from, direction, BentPoint(mix(here, pixel, water.reflectionDistortion), t));
}

// 1 where water is so deep that it mirrors as the sea does, not as the sand below it lies.
float deepEnough(const ShoreSeen shore) {
    return smoothstep(0.1, 0.4, shore.thick);
}

// Of a place, by the sand at the point [m].
float overSand(const SurfacePoint s, vec3 at) {
    return at.y - calmLevel() + s.shore.depth - dot(s.shore.bedSlope, at.xz - s.position.xz);
}

// What runs up the sand stands above the plane that the image mirrors about, which there lies in the sand: the image shows
// sand, which no ray from above it meets. Share of what else there is.
float shareAboveSand(const SurfacePoint s, BentPoint point) {
    vec3 met = shownBy(point.pixel, max(infoAt(point.pixel), 0.0));
    return max(smoothstep(0.05, 0.25, overSand(s, met)), deepEnough(s.shore));
}

// Whether a point of a ray is behind what stands out of the sand, by less than that is thick, or than the ray has come since it was
// before the scene [m].
bool meetsOverSand(const SurfacePoint s, vec3 at, float since) {
    const float thickest = 0.6;    // what is seen from before is taken to be so thick [m]
    const float footing = 0.05;    // over which it stands out of the sand [m]
    Behind b = behindAt(pixelOf(at).xy);
    float behind = distanceTo(at) - distanceTo(b.seen);
    return !b.nothing && behind > 0.0 && behind < thickest + since && overSand(s, b.seen) > footing;
}

// What stands on the beach, as the film on wet sand and the water's edge mirror it: these lie above the plane that the image mirrors
// about. So the scene's depth is followed along the ray, in even steps of the screen. Radiance, and 1 where it meets something.
vec4 mirroredOverSand(const SurfacePoint s, vec3 direction) {
    const int steps = 24;
    const int halvings = 4;
    const float farthest = 60.0;   // of what is large enough to be told in a film [m]
    vec4 from = homogeneousPixel(s.position), by = homogeneousPerMetre(direction);
    float end = min(untilBorder(from, by, vec2(regionSize())), farthest);
    float last = 0.0, met = 0.0;
    int i = 0, halved = 0;
    [[dont_unroll]] do {
        // Evenly on the screen; from where it meets something on, what lies between that and the last before the scene is halved.
        float along = (float(i) + 1.0) / float(steps);
        float t = along * from.w * end / mix(from.w + end * by.w, from.w, along);
        if (met > 0.0) t = 0.5 * (last + met);
        halved += met > 0.0 ? 1 : 0;
        if (meetsOverSand(s, s.position + t * direction, t - last)) met = t;
        else last = t;
    } while (++i < steps + halvings && halved < halvings && (met > 0.0 || i < steps));
    if (met <= 0.0) return vec4(0.0);
    return vec4(radianceOf(behindAt(pixelOf(s.position + met * direction).xy)), 1.0);
}

// A ray that goes on to the sky is looked up far from where it leaves the water, and blurred there: with what other water
// before it mirrors. Share of what the blur meets that lies ahead of the ray.
float shareAhead(vec3 from, vec3 direction, vec2 pixel, float mip) {
    const vec2 taps[4] = vec2[](vec2(-0.5, -0.25), vec2(0.25, -0.5), vec2(0.5, 0.25), vec2(-0.25, 0.5));
    vec2 counted = vec2(0.0);
    int i = 0;
    [[dont_unroll]] do {
        vec2 tap = pixel + taps[i] * exp2(mip) * water.reflectionScale;
        float info = infoAt(tap);
        vec3 met = shownBy(tap, info);
        if (infoIsHit(info)) counted += vec2(dot(met.xz - from.xz, direction.xz) > 0.0 ? 1.0 : 0.0, 1.0);
    } while (++i < 4);
    return counted.x / max(counted.y, 1.0);
}

// How many texels are blurred into one for rays within `spread` radians [standard deviation] that go on for `distance` metres.
float blurTexels(vec3 from, float spread, float distance) {
    // A quarter: mips blur alike in all directions, but at grazing angles slopes turn the mirrored ray mostly up and down,
    // and a mast must stay a line.
    float width = bundleWidth(0.25 * spread * water.reflectionDistortion, distance, water.reflectionBlur.xyz);
    float toEye = length(from) + (sightIsParallel() ? endlesslyFar : 0.0);
    return bundleTexels(width, toEye, distance, toEye / (pixelWidth(from) * water.reflectionScale));
}

// What lies a little beyond the border is as what shows at it, rather than sky; of a bed more is known there. Share of that.
float heldInside(inout vec2 pixel, bool intoWater) {
    const float reach = 0.05;   // of the picture's size
    vec2 size = vec2(regionSize());
    vec2 held = heldInRegion(pixel);
    vec2 beyond = abs(pixel - held) / (intoWater ? vec2(1.0) : reach * size);
    pixel = held;
    return 1.0 - smoothstep(0.0, 1.0, max(beyond.x, beyond.y));
}

// Radiance times confidence, and confidence. Rays within the pixel spread by `spread` radians [standard deviation]; the
// farther they go, the more of the reflection they meet. `hit` is how far that is [m]: from a ray beside it, to the next.
vec4 reflectionAlong(const SurfacePoint s, vec3 direction, float spread, inout float hit) {
    if (sharpDownscale > 0) {
        vec2 here = s.pixel / float(sharpDownscale);
        vec4 texel = sharpDownscale > 1 ? knownBetween(reflectionColor, reflectionInfo, here) : texelFetch(reflectionColor, ivec2(here), 0);
        return texel * shareOfScene(hit, water.reflectionBlur.xyz);
    }
    BentPoint point = bentPoint(s.pixel, s.position, direction, hit, 1);
    hit = point.distance;
    float inside = heldInside(point.pixel, direction.y < 0.0);
    if (hasWaves) inside *= water.mirror.y;
    if (inside <= 0.0) return vec4(0.0);
    if (hasShore) inside *= shareAboveSand(s, point);
    float mip = bundleMip(blurTexels(s.position, spread, point.distance));
    inside *= shareOfScene(point.distance, water.reflectionBlur.xyz);
    if (hasWaves && point.distance >= farAway) inside *= shareAhead(s.position, direction, point.pixel, mip);
    return inside * reflectionAt(point.pixel, mip);
}

// What is known where the bent ray leads: of one that meets nothing the image may show what lies behind the ray.
float infoMet(BentPoint point) {
    float info = infoAt(point.pixel);
    return infoIsHit(info) && point.distance >= farAway ? infoSky : info;
}

// Where in the region the mirrored thing is taken from, its distance from the surface and its ReflectionClass. A texel
// of the reflection says how far away its mirror image is; the lookup's own ray meets it there.
vec4 reflectionSource(const SurfacePoint s, vec3 direction) {
    BentPoint point = bentPoint(s.pixel, s.position, direction, hitAt(s.pixel), 2);
    vec2 pixel = point.pixel;
    float info = infoMet(point);
    if (!infoIsHit(info)) return vec4(-1.0, -1.0, 0.0, infoIsSky(info) ? 1.0 : 0.0);
    Ray throughTexel = rayThrough((floor(pixel / water.reflectionScale) + 0.5) * water.reflectionScale);
    vec3 source = mirroredPoint(rayThrough(pixel), throughTexel, info, calmNormal(), water.mirror.x);
    vec4 seen = pixelOf(source);
    return seen.w > 0.0 ? vec4(seen.xy, info, 2.0) : vec4(-1.0, -1.0, info, 2.0);
}

vec3 classColor(const SurfacePoint s, vec3 direction) {
    float info = infoMet(bentPoint(s.pixel, s.position, direction, hitAt(s.pixel), 2));
    if (infoIsHit(info)) return vec3(0.0, 1.0, 0.0);
    return infoIsSky(info) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
}

#endif
