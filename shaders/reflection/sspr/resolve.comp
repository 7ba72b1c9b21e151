// SSPR, second pass: turns mirrored depths into colour. A key says roughly how far along this pixel's mirrored ray
// something lies; the ray is met there with the plane through the scene's depths, and the key counts only when they meet
// within the very pixel those depths were taken from. Holes are filled and leaks refused by proof instead of by likeness
// of colour. With OVERHANGS, what hangs over the mirror is looked for, too.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "mirror.glsl"
#include "encoding.glsl"
#include "edge_fade.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform writeonly image2D reflectionInfo;

#include "scene_depth.glsl"
#include "miss.glsl"
#include "depth_quads.glsl"
#include "tile_list.glsl"
#include "keys.glsl"
#include "screen_ray.glsl"
#include "overhang_taps.glsl"
#include "hidden_way.glsl"
#include "hits.glsl"
#include "source_color.glsl"
#include "hit_distance.glsl"
#ifdef OVERHANGS
#include "overhangs.glsl"
#endif

const int refinements = 3;
const int holeCells = 12;   // to each side
// From the middle of the source [pixel]: within it; a little off, where nothing else claims this pixel; or between two
// pixels that claim the same.
const float withinPixel = 0.52;
const float besidePixel = 0.75;
const float betweenPixels = 1.5;
const float mostLoose = 4.0;
const float unseenPixels = 8.0;   // that things are taken to go on out of sight

// The smaller of the steps to both sides, since the other may lead off the surface; none where they part in sign, as on
// what is a pixel wide (minmod, van Leer 1979).
float edgeAwareStep(float before, float after) {
    if (before * after <= 0.0) return 0.0;
    return abs(before) < abs(after) ? before : after;
}

// A pixel's depth and, since depth is affine on the screen over any plane, its steps from the pixels before and to those
// after; none over the border.
struct Surface {
    float depth;
    vec2 before;
    vec2 after;
};

Surface surfaceAt(const MirrorBlock mirror, ivec2 pixel) {
    vec2 perTexel = perDepthTexel();
    vec4 before = depthsAround(mirror, pixel, perTexel);
    vec4 after = depthsAround(mirror, pixel + 1, perTexel);
    bvec2 first = equal(pixel, ivec2(0));
    bvec2 last = equal(pixel, regionSize(mirror) - 1);
    return Surface(after.w, mix(after.w - before.xz, vec2(0.0), first), mix(after.zx - after.w, vec2(0.0), last));
}

// Where the ray meets the plane through a pixel's depth; valid within that pixel. Where the steps to both sides differ, as
// on what is thin, it has the benefit of the doubt on which side it meets.
Hit metWithin(const MirrorBlock mirror, float accepted, ScreenRay ray, vec2 middle, Surface seen) {
    float depth = seen.depth;
    vec2 gradient = vec2(edgeAwareStep(seen.before.x, seen.after.x), edgeAwareStep(seen.before.y, seen.after.y));
    // z - depth w - gradient . (xy - middle w) = 0 on the plane.
    vec4 surface = vec4(-gradient, 1.0, dot(gradient, middle) - fromInfinity(mirror, depth));
    float perMet = dot(surface, ray.along);
    float met = -dot(surface, ray.origin) / perMet;
    vec4 p = ray.origin + met * ray.along;
    vec2 source = p.xy / p.w;
    // As far as the depth's last digit moves it.
    vec2 loose = min(abs(mirror.depthStep / perMet * (ray.along.xy - source * ray.along.w)), mostLoose);
    vec2 away = abs(source - middle) - loose;
    float off = max(away.x, away.y);
    vec2 across = ray.along.xy - middle * ray.along.w;
    vec2 most = max(-seen.before * across, -seen.after * across) + mirror.depthStep * abs(across);
    bool front = ray.along.z - fromInfinity(mirror, depth) * ray.along.w + most.x + most.y > 0.0;
    return Hit(met > 0.0 && met <= 1.0 && p.w > 0.0 && off <= accepted, front, source, off, met);
}

// The middle of the pixel that a point lies next to. Just off an edge, what stands there still covers part of the pixel.
vec2 besides(vec2 middle, vec2 point) {
    vec2 off = point - middle;
    return middle + (abs(off.x) > abs(off.y) ? vec2(sign(off.x), 0.0) : vec2(0.0, sign(off.y)));
}

// A point that was met, or where the pixel by which it was met is nearest to it, if what lies under the plane's horizon shows
// beside that. Sky beside it softens the outline.
vec2 shownIn(const MirrorBlock mirror, vec2 source, vec2 middle) {
    ivec2 pixel = regionPixel(mirror, source);
    bool below = wellBelowPlane(mirror, vec3(vec2(pixel) + 0.5, depthAt(mirror, pixel)));
    return below ? clamp(source, middle - 0.49, middle + 0.49) : source;
}

Hit refined(const MirrorBlock mirror, float accepted, ScreenRay ray, float mirroredDepth, inout vec2 middle) {
    vec4 p = ray.origin + mirroredDepth * ray.along;
    if (!(p.w > 0.0)) return noHit;
    Hit hit = Hit(false, false, p.xy / p.w, 0.0, mirroredDepth);
    bool movedOver = false;
    int left = refinements;
    do {
        if (!insideRegion(mirror, hit.source)) return noHit;
        ivec2 pixel = ivec2(hit.source);
        Surface seen = surfaceAt(mirror, pixel);
        middle = vec2(pixel) + 0.5;
        if (!solid(mirror, pixel, seen.depth)) {
            if (movedOver) return noHit;
            movedOver = true;
            hit.source = besides(middle, hit.source);
        } else {
            hit = metWithin(mirror, accepted, ray, middle, seen);
        }
    } while (--left > 0 && !hit.valid);
    return hit.valid ? hit : noHit;
}

// The keys in and around a cell, loaded once.
struct KeysAround {
    uvec3 before;
    uvec3 level;
    uvec3 after;
};

uvec3 keysInRow(const MirrorBlock mirror, ivec2 cell) {
    return uvec3(keyAt(mirror, cell - ivec2(1, 0)), keyAt(mirror, cell), keyAt(mirror, cell + ivec2(1, 0)));
}

KeysAround keysAround(const MirrorBlock mirror, ivec2 cell) {
    return KeysAround(keysInRow(mirror, cell - ivec2(0, 1)), keysInRow(mirror, cell), keysInRow(mirror, cell + ivec2(0, 1)));
}

uvec3 fartherThan(uint last, uvec3 some) {
    return mix(uvec3(noKey), some, lessThan(some, uvec3(last)));
}

// The nearest key that is farther than `last`, whose turn is over.
uint nextKey(KeysAround around, uint last) {
    uvec3 farther = max(fartherThan(last, around.before), fartherThan(last, around.level));
    farther = max(farther, fartherThan(last, around.after));
    return max(max(farther.x, farther.y), farther.z);
}

// Nearer keys lead to the same place of the picture.
uint beyond(const MirrorBlock mirror, ScreenRay ray, float mirroredDepth) {
    vec4 p = ray.origin + mirroredDepth * ray.along;
    vec2 shift = ray.along.xy - p.xy / p.w * ray.along.w;
    float quarterPixel = 0.25 * abs(p.w) / max(length(shift), 1e-30);
    return keyFromDepth(mirror, clamp(mirroredDepth - signedDepth(mirror, quarterPixel), 0.0, 1.0));
}

const int keysAroundCell = 9;

// The nearest key in and around the cell first: where a near surface is mirrored larger than it is seen, its keys leave
// holes, and what shows through them would prove itself as well. The first that does counts; `past`: it is not the nearest.
// `own`: the cell's key.
Hit nearestHit(const MirrorBlock mirror, ivec2 cell, ScreenRay ray, out bool past, out uint own) {
    Hit hit = noHit;
    KeysAround around = keysAround(mirror, cell);
    own = around.level.y;
    uint key = nextKey(around, ~0u);
    int left = keysAroundCell;
    vec2 middle = vec2(0.0);
    if (key != noKey) {
        do {
            hit = refined(mirror, key > own && own != noKey ? withinPixel : besidePixel, ray, depthFromKey(mirror, key), middle);
            key = nextKey(around, min(key, beyond(mirror, ray, depthFromKey(mirror, key))));
        } while (--left > 0 && key != noKey && !hit.valid);
    }
    past = left < keysAroundCell - 1;
    if (hit.valid) hit.source = shownIn(mirror, hit.source, middle);
    return hit;
}

struct Hole {
    bool inside;
    bool beside;    // what is mirrored
    Guesses left;   // by what
};

// What is seen edge on is mirrored many times larger, and its keys lie far apart, but only along the line through a pixel
// and its source, which is the same for all depths. Between keys on that line a miss may be such a hole, and those nearer
// than what shows here may have left it.
Hole holeAround(const MirrorBlock mirror, vec2 q, ScreenRay ray, uint here) {
    vec4 p = ray.origin + 0.5 * ray.along;
    vec2 direction = p.xy / p.w - q;
    vec2 step = direction / max(farthest(direction), 1e-6);
    vec2 cell = q / float(keyEdge(mirror));
    LineKey ahead = LineKey(noKey, ivec2(0));
    LineKey behind = ahead;
    bvec2 keysBeside = bvec2(false);
    // Not do-while: SwiftShader's invocations that leave one before others lose what its last round loaded.
    for (int i = 1; i <= holeCells && (ahead.key == noKey || behind.key == noKey); ++i) {
        ivec2 next = texelAt(cell + float(i) * step, lastCell(mirror));
        ivec2 last = texelAt(cell - float(i) * step, lastCell(mirror));
        uint nextKey = keyAt(mirror, next);
        uint lastKey = keyAt(mirror, last);
        keysBeside = bvec2(keysBeside.x || nextKey != noKey, keysBeside.y || lastKey != noKey);
        if (ahead.key == noKey && nextKey > here) ahead = LineKey(nextKey, next);
        if (behind.key == noKey && lastKey > here) behind = LineKey(lastKey, last);
    }
    return Hole(all(keysBeside), any(keysBeside), Guesses(sourceOf(mirror, ahead), sourceOf(mirror, behind)));
}

// Where a ray goes in behind what is seen by no more than two pixels cover: what is too narrow to tell its slope is taken
// to be about as thick as wide.
Hit hitOnThin(const MirrorBlock mirror, ScreenRay ray, Entry entry) {
    if (entry.between == noGuesses) return noHit;
    float depth = depthAt(mirror, entry.between.other);
    if (!solid(mirror, entry.between.other, depth)) return noHit;
    vec4 seen = homogeneousPoint(mirror, vec4(entry.hidden, depth, 1.0));
    vec4 beside = seen + homogeneousPerColumn(mirror);
    vec4 hidden = seen + homogeneousPerDepth(mirror) * (depthFromInfinity(mirror, entry.depth) - depth);
    vec3 at = seen.xyz / seen.w;
    bool thin = distance(hidden.xyz / hidden.w, at) <= 2.0 * distance(beside.xyz / beside.w, at);
    return Hit(thin, thin, entry.hidden, 0.0, depthOn(ray, entry.hidden));
}

Hit metAt(const MirrorBlock mirror, ScreenRay ray, ivec2 pixel) {
    if (pixel == nowhere) return noHit;
    Surface seen = surfaceAt(mirror, pixel);
    Hit hit = metWithin(mirror, unseenPixels, ray, vec2(pixel) + 0.5, seen);
    hit.valid = hit.valid && solid(mirror, pixel, seen.depth) && insideRegion(mirror, hit.source);
    return hit;
}

Hit metBetween(const MirrorBlock mirror, Guesses guesses, Hit one, Hit other) {
    one.valid = one.valid && one.off <= betweenPixels;
    other.valid = other.valid && other.off <= betweenPixels;
    bool alike = one.front == other.front;
    bool agree = one.valid && other.valid && alike && farthest(one.source - other.source) <= betweenPixels;
    bool isOne = one.valid && (!other.valid || (alike ? one.off <= other.off : one.front));
    Hit best = isOne ? one : other;
    best.valid = best.valid && (agree || best.front && best.off <= besidePixel);
    if (best.valid) best.source = shownIn(mirror, best.source, vec2(isOne ? guesses.one : guesses.other) + 0.5);
    return best;
}

// How near what is seen at a point is, of how near something else is.
float nearnessAt(const MirrorBlock mirror, vec2 point, float than) {
    return fromInfinity(mirror, depthAt(mirror, regionPixel(mirror, point))) / than;
}

// Where the ray meets, out of sight, the plane of what shows beside: that is hidden from there on, and does not end; and goes on
// to the other side, too, as rails and ropes do not.
Hit unseen(const MirrorBlock mirror, ScreenRay ray, ivec2 pixel, Hit hit) {
    if (!hit.valid) return hit;
    vec2 shown = vec2(pixel) + 0.5;
    float nearness = fromInfinity(mirror, depthAt(mirror, ivec2(shown)));
    vec2 way = hit.source - shown;
    vec2 step = way / max(farthest(way), 1.0);
    float next = min(nearnessAt(mirror, shown + step, nearness),
                     nearnessAt(mirror, shown + min(2.0, farthest(way)) * step, nearness));
    float beyond = nearnessAt(mirror, shown - 0.5 * unseenPixels * step, nearness);
    bool goesOn = next > 0.9 && beyond > 0.9 && beyond < 1.1;
    hit.valid = hit.front && goesOn && hides(mirror, hit.source, rayDepthAt(ray, hit.source));
    hit.source = shown;
    return hit;
}

Hit metUnseen(const MirrorBlock mirror, ScreenRay ray, Guesses guesses, Hit one, Hit other) {
    int i = 0;
    // Both by one copy of code, and where no invocation comes here, CPU devices go through it once.
    [[dont_unroll]] do {
        Hit first = one;
        one = other;
        other = unseen(mirror, ray, i == 0 ? guesses.one : guesses.other, first);
    } while (++i < 2);
    return one.valid && (!other.valid || one.off <= other.off) ? one : other;
}

// Between two pixels that lie side by side there is no gap.
bool touch(Guesses sides) {
    return sides.one != nowhere && sides.other != nowhere && farthest(vec2(sides.one - sides.other)) <= 1.0;
}

// What a pixel of the mirror shows.
struct Shown {
    Hit hit;
    bool comesOut;   // the nearest key shows what the ray comes out of
    float info;      // where no hit is valid
};

Shown shownAt(const MirrorBlock mirror, vec2 q, ScreenRay ray) {
    bool followed = mirror.followed != 0u;
    ivec2 cell = keyCell(mirror, ivec2(q));
    bool past = false;
    uint own;
    Hit hit = nearestHit(mirror, cell, ray, past, own);
    bool comesOut = hit.valid && !hit.front;
    // What is met past two sides that touch, through the step of a clinker hull for one, is hidden by them.
    bool pastSides = past && hit.valid && hit.front;
    bool inHole = false;
    float info = infoUnknown;
    Guesses guesses = noGuesses;
    Hit thin = noHit;
    if (!hit.valid || pastSides) {
        Hole hole = holeAround(mirror, q, ray, pastSides ? keyFromDepth(mirror, hit.depth) : own);
        if (!hit.valid && !hole.inside) info = infoOfMiss(mirror, q);
        if (!hit.valid && followed && hole.beside && info == infoSky) info = infoDoubtedSky;
        guesses = hole.left;
        inHole = hole.inside;
        pastSides = pastSides && touch(guesses);
    }
    if (comesOut) {
        Entry entry = entryBefore(mirror, ray, q, hit.source, backPixels);
        guesses = entry.between;
        thin = hitOnThin(mirror, ray, entry);
    }
    if (!hit.front || pastSides) {
        Hit one = noHit;
        Hit other = noHit;
        int i = 0;
        // Both by one copy of code, and where no invocation comes here, CPU devices go through it once.
        [[dont_unroll]] do {
            one = other;
            other = metAt(mirror, ray, i == 0 ? guesses.one : guesses.other);
        } while (++i < 2);
        Hit met = metBetween(mirror, guesses, one, other);
        // Where rays are followed they tell better.
        bool tells = pastSides ? met.front : !comesOut || met.front && (!followed || met.off <= withinPixel);
        if (met.valid && tells) hit = met;
        else if (thin.valid) hit = thin;
        else if (inHole && !pastSides) hit = metUnseen(mirror, ray, guesses, one, other);
    }
    return Shown(hit, comesOut, info);
}

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = pixelToResolve(mirror);
    if (pixel == noPixel) return;
    vec2 q = middleOf(mirror, pixel);
    vec4 color = vec4(0.0);
    float info = infoUnknown;
    if (planeAhead(mirror, q)) {
        ScreenRay ray = rayOf(mirror, q);
        Shown shown = shownAt(mirror, q, ray);
        Hit hit = shown.hit;
#ifdef OVERHANGS
        if (!shown.comesOut) {
            Hit overhang = underOverhang(mirror, q, ray, hit);
            if (overhang.valid) hit = overhang;
        }
#endif
        info = shown.info;
        if (hit.valid) {
            float confidence = edgeConfidence(mirror, q, hit.source);
            float light = hit.front ? confidence : confidence * mirror.undersideLight;
            color = vec4(sourceColor(mirror, hit.source, rayDepthAt(ray, hit.source)) * light, confidence);
            info = infoOfHit(distanceToHit(mirror, q, hit.depth));
            if (mirror.followed != 0u && (shown.comesOut || !hit.front)) info = infoOfDoubt(info);
        }
    }
    imageStore(reflectionColor, pixel, color);
    imageStore(reflectionInfo, pixel, vec4(info, 0.0, 0.0, 0.0));
}
