// What hangs over a mirror, a pier's deck for one, as the mirror shows it from below: the eye sees its top and its edge, and the
// ray that meets its underside leaves by its hidden back.
#ifndef OVERHANGS_GLSL
#define OVERHANGS_GLSL

#include "hits.glsl"
#include "overhang_taps.glsl"

const float leastHeight = 3.0;   // of its edge above the mirror [pixels]: what floats hangs nowhere
const float levelWithin = 0.15;  // of its thickness
const float steepestTop = 0.2;   // its rise for each metre of the way between two pixels
const int sideTaps = 9;          // each twice as far aside
const float sidePixels = 4.0;    // that its edge is followed, to tell which way it runs
const int mostHalvings = 10;     // of the way from its edge to what stands on it
const int topTaps = 7;           // behind its edge, each twice as far
const float edgeWithin = 3.0;    // from its edge's own height [pixels]

// What left a key nearer than what shows here, nearer to the eye on the mirror: on the screen, it hides the ray before that
// comes to what shows here. What stands on what hangs does not where the ray comes out before it: then, the nearest.
ivec2 overhangBefore(const MirrorBlock mirror, vec2 q, ScreenRay ray, vec2 away, uint here) {
    LineKey first = LineKey(noKey, ivec2(0));
    LineKey last = first;
    // Not by a uniform alone: llvmpipe compiles a shader that a uniform halves anew in each frame.
    int taps = farthest(away) > 0.0 ? tapsPerOctave * int(mirror.overhangSamples) : 0;
    for (int i = 0; i < taps; ++i) {
        ivec2 cell = cellBefore(mirror, q, away, i);
        uint key = keyAt(mirror, cell);
        bool found = key > here;
        bool isFirst = found && first.key == noKey;
        first.key = isFirst ? key : first.key;
        first.cell = isFirst ? cell : first.cell;
        last.key = found ? key : last.key;
        last.cell = found ? cell : last.cell;
    }
    ivec2 overhang = sourceOf(mirror, first);
    vec2 middle = vec2(overhang) + 0.5;
    return hides(mirror, middle, rayDepthAt(ray, middle)) ? overhang : sourceOf(mirror, last);
}

// What is seen in the pixel of a point, as a screen point.
vec4 seenPoint(const MirrorBlock mirror, vec2 point) {
    ivec2 pixel = regionPixel(mirror, point);
    return vec4(vec2(pixel) + 0.5, depthAt(mirror, pixel), 1.0);
}

// The mirrored depth at which a ray is as high.
float depthAtHeight(const MirrorBlock mirror, vec2 q, float height) {
    vec4 start = vec4(q, 0.0, 1.0);
    float perDepth = mirror.heightRow.z + height * mirror.weightRow.z;
    return -(dot(mirror.heightRow, start) + height * weightOf(mirror, start)) / perDepth;
}

float metresPerPixel(const MirrorBlock mirror, vec4 point) {
    vec4 p = homogeneousPoint(mirror, point);
    vec4 beside = p + homogeneousPerColumn(mirror);
    return distance(p.xyz / p.w, beside.xyz / beside.w);
}

const float noRise = 1e30;

float riseOf(const MirrorBlock mirror, vec4 here, vec4 next) {
    return isFar(mirror, next.z) ? noRise : abs(heightOf(mirror, next) - heightOf(mirror, here));
}

// Whether a top is level there, as a rail or a wall is not: to the more level side, since it may be two pixels high.
bool isLevel(const MirrorBlock mirror, vec2 point, vec2 away, float edgeHeight) {
    vec4 here = seenPoint(mirror, point);
    if (isFar(mirror, here.z)) return false;
    vec4 next = seenPoint(mirror, point - away);
    vec4 after = seenPoint(mirror, point + away);
    float rise = riseOf(mirror, here, next);
    float riseAfter = riseOf(mirror, here, after);
    if (riseAfter < rise) next = after;
    rise = min(rise, riseAfter);
    if (rise == noRise) return false;
    vec3 way = unprojected(mirror, here.xyz) - unprojected(mirror, next.xyz);
    return rise < levelWithin * (heightOf(mirror, here) - edgeHeight) && rise < steepestTop * length(way);
}

// A level point of the top between its edge and what stands on it, which is nearer the end: halfway in depth, which is
// affine on the screen over the top and hardly changes over what is upright. What stands so high that its end is nearer to the eye
// than the edge is told by its depth, which falls: the point lies halfway to its foot.
bool levelBetween(const MirrorBlock mirror, vec4 edge, vec2 end, vec2 away, float edgeHeight, out vec2 point) {
    float halfway = 0.5 * (edge.z + seenPoint(mirror, end).z);
    bool falls = signedDepth(mirror, halfway - edge.z) > 0.0;
    float before = 0.0;
    float after = max(farthest(end - edge.xy), 1.0);
    int halvings = mostHalvings;
    do {
        float middle = 0.5 * (before + after);
        float seen = seenPoint(mirror, edge.xy + middle * away).z;
        float than = falls ? seenPoint(mirror, edge.xy + (middle - 1.0) * away).z : halfway;
        bool beyond = signedDepth(mirror, seen - than) < 0.0 != falls;
        before = beyond ? before : middle;
        after = beyond ? middle : after;
    } while (--halvings > 0 && after - before > 0.5);
    point = edge.xy + (falls ? 0.5 * before : after) * away;
    return isLevel(mirror, point, away, edgeHeight);
}

// On the screen, along a line at that height over a point that is parallel to the edge of the upright face at another.
vec2 alongEdge(const MirrorBlock mirror, vec4 edge, vec4 over, float top) {
    vec2 horizon = vec2(-mirror.heightRow.y, mirror.heightRow.x) / max(length(mirror.heightRow.xy), 1e-30);
    vec2 to = sidePixels * horizon;
    vec3 before = edge.xyz - seenPoint(mirror, edge.xy - to).xyz;
    vec3 after = seenPoint(mirror, edge.xy + to).xyz - edge.xyz;
    vec4 mirrored = mirror.screenMirror * edge;
    vec3 face = cross(abs(before.z) < abs(after.z) ? before : after, mirrored.xyz - mirrored.w * edge.xyz);
    face -= dot(face, over.xyz - edge.xyz) / weightOf(mirror, over) * mirror.weightRow.xyz;
    vec2 along = cross(face, rowOver(mirror, top).xyz).xy;
    return along / max(farthest(along), 1e-30);
}

// A level point of the top behind its edge where what stands on that very edge hides it: to one side, as far as the edge goes on.
bool levelBeside(const MirrorBlock mirror, vec4 edge, vec2 away, float edgeHeight, out vec2 point) {
    vec2 aside = alongEdge(mirror, edge, edge, edgeHeight);
    float within = edgeWithin * metresPerPixel(mirror, edge);
    bvec2 goesOn = bvec2(true);
    bool level = false;
    int i = 0;
    do {
        bool other = (i & 1) != 0;
        // A pixel higher, so that a row's end does not count as the edge's.
        vec2 beside = edge.xy + away + (other ? -1.0 : 1.0) * float(1 << (i >> 1)) * aside;
        vec4 seen = seenPoint(mirror, beside);
        bool still = (other ? goesOn.y : goesOn.x) && insideRegion(mirror, beside) && !isFar(mirror, seen.z) &&
            abs(heightOf(mirror, seen) - edgeHeight) < within;
        goesOn = bvec2(other ? goesOn.x : still, other ? still : goesOn.y);
        for (int tap = 0; tap < topTaps && still && !level; ++tap) {
            point = beside + float(1 << tap) * away;
            level = isLevel(mirror, point, away, edgeHeight);
        }
    } while (++i < 2 * sideTaps && any(goesOn) && !level);
    return level;
}

// Whether a level top of that height is seen, there or past what stands on it and hides it there: to one side, where all the
// way what is seen is no lower.
bool topShows(const MirrorBlock mirror, inout vec2 point, vec2 aside, vec2 away, float edgeHeight, float top) {
    float within = levelWithin * (top - edgeHeight);
    vec2 middle = point;
    bvec2 higher = bvec2(true);
    bool level;
    int i = 0;
    do {
        bool other = (i & 1) != 0;
        point = middle + (i == 0 ? 0.0 : other ? -float(1 << ((i + 1) >> 1)) : float(1 << (i >> 1))) * aside;
        vec4 seen = seenPoint(mirror, point);
        float rise = insideRegion(mirror, point) && !isFar(mirror, seen.z) ? heightOf(mirror, seen) - top : -top;
        bool still = rise >= -within && (other ? higher.y : higher.x);
        level = still && rise <= within && isLevel(mirror, point, away, edgeHeight);
        higher = bvec2(other ? higher.x : still, (other || i == 0) ? still && higher.y : higher.y);
    } while (++i < 2 * sideTaps && any(higher) && !level);
    return level;
}

// Where the ray is as high as the edge that it goes in under, it meets an underside, provided that straight above a level top
// is seen, as high as the one by which the ray gets out of sight, or what stands on that.
Hit hitUnderTop(const MirrorBlock mirror, vec2 q, ScreenRay ray, vec2 away, vec4 edge, float depth, vec2 on) {
    float height = heightOf(mirror, edge);
    float top = heightOf(mirror, seenPoint(mirror, on));
    vec4 mirrored = vec4(q, fromInfinity(mirror, depth), 1.0);
    vec4 above = mix(mirrored, ray.origin + depth * ray.along, 0.5 * (top / height + 1.0));
    vec4 over = vec4(above.xyz / above.w, 1.0);
    over.z = depthFromInfinity(mirror, over.z);
    if (!(top > height && above.w > 0.0 && insideRegion(mirror, over.xy))) return noHit;
    vec4 seen = seenPoint(mirror, over.xy);
    vec2 source = over.xy;
    if (isFar(mirror, seen.z)) return noHit;
    // The pixel may show more of the edge than of the top.
    bool onEdge = heightOf(mirror, seen) < top - levelWithin * (top - height);
    if (onEdge) source += away;
    bool level = topShows(mirror, source, alongEdge(mirror, edge, over, top), away, height, top);
    return Hit(level, false, source, 0.0, depth);
}

Hit underOverhang(const MirrorBlock mirror, vec2 q, ScreenRay ray, Hit shown) {
    vec2 away = awayFrom(mirror, q);
    ivec2 overhang = overhangBefore(mirror, q, ray, away, shown.valid ? keyFromDepth(mirror, shown.depth) : noKey);
    vec2 from = vec2(overhang) + 0.5;
    bool first = !shown.valid || dot(shown.source - from, away) > 0.75;
    float mostPixels = float(firstTap << mirror.overhangSamples);
    Hit hit = noHit;
    if (overhang != nowhere && first) {
        Entry entry = entryBefore(mirror, ray, q, from, mostPixels);
        if (entry.between == noGuesses) return noHit;
        vec4 edge = seenPoint(mirror, entry.hidden);
        if (isFar(mirror, edge.z)) return noHit;
        float height = heightOf(mirror, edge);
        float depth = depthAtHeight(mirror, q, height);
        bool above = height > leastHeight * metresPerPixel(mirror, edge);
        bool before = !shown.valid || signedDepth(mirror, depth - shown.depth) > 0.0;
        if (above && before) {
            vec2 end = exitAfter(mirror, ray, from, away, mostPixels);
            // What is level behind the edge may be the top of what stands there.
            for (int beside = 0; beside < 2 && !hit.valid; ++beside) {
                vec2 on;
                bool level = beside == 0 ? levelBetween(mirror, edge, end, away, height, on)
                                         : levelBeside(mirror, edge, away, height, on);
                if (level) hit = hitUnderTop(mirror, q, ray, away, edge, depth, on);
            }
        }
    }
    return hit;
}

#endif
