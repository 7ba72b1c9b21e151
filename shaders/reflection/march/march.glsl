// Follows a ray over the picture: march_strides.glsl or march_cells.glsl say where it goes behind what is seen.
//
// A point moving along a 3D line is a homogeneous screen point that moves linearly: clipping to the picture and to the
// depth range is exact, and between two screen points pixel, depth and 1/w are linear (McGuire and Mara 2014).
#ifndef MARCH_GLSL
#define MARCH_GLSL

#include "scene_depth.glsl"
#include "reflection_info.glsl"
#include "screen_ray.glsl"
#include "march_block.h"

layout(set = 0, binding = settingsBinding, std140) uniform MarchSettings {
    MarchBlock settings;
};

const int falseAlarms = 12;   // crossings that may be turned down before the ray is given up

// What each look at the scene needs, loaded once: CPU devices load uniforms anew in each turn of a loop.
struct Scene {
    ivec2 origin;
    ivec2 lastPixel;
    float depthSign;
    float far;               // signed depth
    vec4 aboveRow;           // positive for (x, y, depth, 1) above the plane by more than is told apart
    float thickness;
    float weightPerDepth;    // signed
};

Scene loadedScene(const MirrorBlock mirror) {
    return Scene(sceneTexel(mirror, ivec2(0)), regionSize(mirror) - 1, depthSign(mirror), signedDepth(mirror, mirror.farDepth),
                 aboveRow(mirror), settings.thickness, signedDepth(mirror, mirror.weightRow.z));
}

// A ray on the screen. All but the metres is linear in the share of its length there; depths are signed so that the nearer
// is the greater.
struct Track {
    vec3 first;           // pixel, signed depth
    vec3 along;           // to its end
    vec4 weights;         // 1/w at its start, and how much more it is at its end; the same of `turns`
    vec2 range;           // [m] along the ray, empty unless the first is less than the second
    float halfPixel;      // as a share
    bool leavesPicture;   // at its end
    Scene scene;
};

// Narrows `range` to where a linear function is not negative.
void keepWhere(float atStart, float perMetre, inout vec2 range) {
    if (perMetre != 0.0) {
        float crossing = -atStart / perMetre;
        if (perMetre > 0.0) range.x = max(range.x, crossing);
        else range.y = min(range.y, crossing);
    } else if (atStart < 0.0) {
        range.y = -1.0;
    }
}

vec4 screenPoint(vec4 homogeneous) {
    return vec4(homogeneous.xyz, 1.0) / homogeneous.w;
}

// How distance ahead turns with depth at a screen point whose 1/w is `weight`; see within().
float turnsWithDepth(const MirrorBlock mirror, vec3 point, float weight) {
    vec4 row = settings.forwardRow;
    return signedDepth(mirror, dot(row, vec4(point, 1.0)) * mirror.weightRow.z - row.z * weight);
}

Track trackOf(const MirrorBlock mirror, vec4 start, vec4 perMetre, float metres) {
    vec2 size = vec2(regionSize(mirror));
    vec2 picture = vec2(0.0, metres);
    keepWhere(start.x, perMetre.x, picture);
    keepWhere(start.y, perMetre.y, picture);
    keepWhere(size.x * start.w - start.x, size.x * perMetre.w - perMetre.x, picture);
    keepWhere(size.y * start.w - start.y, size.y * perMetre.w - perMetre.y, picture);
    // Depth runs from the one to the other, one of them the near plane.
    vec2 greatest = vec2(start.w - start.z, perMetre.w - perMetre.z);
    vec2 least = vec2(start.z, perMetre.z);
    vec2 near = nearerIsGreater(mirror) ? greatest : least;
    vec2 far = nearerIsGreater(mirror) ? least : greatest;
    keepWhere(near.x, near.y, picture);
    Track track;
    track.range = picture;
    keepWhere(far.x, far.y, track.range);
    track.leavesPicture = picture.y < metres && track.range.y >= picture.y;
    vec4 first = screenPoint(start + perMetre * track.range.x);
    vec4 last = screenPoint(start + perMetre * track.range.y);
    vec3 toSigned = vec3(1.0, 1.0, depthSign(mirror));
    track.first = first.xyz * toSigned;
    track.along = (last.xyz - first.xyz) * toSigned;
    vec2 turns = vec2(turnsWithDepth(mirror, first.xyz, first.w), turnsWithDepth(mirror, last.xyz, last.w));
    track.weights = vec4(first.w, last.w - first.w, turns.x, turns.y - turns.x);
    float pixels = max(abs(track.along.x), abs(track.along.y));
    track.halfPixel = min(0.5 / max(pixels, 1e-6), 1.0);
    track.scene = loadedScene(mirror);
    return track;
}

vec3 trackPoint(Track track, float share) {
    return track.first + share * track.along;
}

float trackMetres(Track track, float share) {
    vec2 weights = vec2(1.0 - share, share) * vec2(track.weights.x, track.weights.x + track.weights.y);
    return dot(weights, track.range) / (weights.x + weights.y);
}

float depthAt(const MirrorBlock mirror, vec2 pixel) {
    return texelFetch(sceneDepth, sceneTexel(mirror, ivec2(pixel)), 0).r;
}

// What a ray can be behind.
struct Seen {
    float depth;    // signed
    bool counts;
};

// What lies on the plane or below is the mirror itself, or shines through it: no ray above can be behind that.
Seen seenAt(Scene scene, ivec2 pixel) {
    float depth = texelFetch(sceneDepth, scene.origin + pixel, 0).r;
    float above = dot(scene.aboveRow, vec4(vec2(pixel) + 0.5, depth, 1.0));
    return Seen(scene.depthSign * depth, scene.depthSign * depth > scene.far && above > 0.0);
}

ivec2 pixelAt(Scene scene, vec2 point) {
    return texelAt(point, scene.lastPixel);
}

// Whether of two signed depths, where a ray is at the depth `ray`, one is at most `thickness` behind the other. Both distances
// ahead of the eye are fractions N/W; with N and W affine in depth, their difference is `turns` times the depths', over both
// W. Multiplied out, it costs no division.
bool within(Track track, float share, float ray, float farther, float nearer) {
    vec2 here = track.weights.xz + share * track.weights.yw;
    float weight = here.x + track.scene.weightPerDepth * (farther - ray);
    float deeper = nearer - farther;
    return deeper * here.y <= track.scene.thickness * weight * (weight + track.scene.weightPerDepth * deeper);
}

bool within(Track track, float share, float ray, float seen) {
    return within(track, share, ray, ray, seen);
}

// The smaller step to both sides; none where they part in sign, as on what is a pixel wide (minmod, van Leer 1979). A step
// is sure where the next one goes on like it: over a plane depth is affine on the screen.
struct Slope {
    float perPixel;
    bool sure;
    vec2 steps;   // to both sides
};

// How far the difference of two depths may be off.
float roundingAt(const MirrorBlock mirror, float depth) {
    return 1e-6 * abs(depth) + mirror.depthStep;
}

Slope slopeOf(const MirrorBlock mirror, float before2, float before, float here, float after, float after2) {
    float left = here - before;
    float right = after - here;
    float rounding = 2.0 * roundingAt(mirror, here);
    bool leftSure = abs(left - (before - before2)) <= 0.1 * abs(left) + rounding;
    bool rightSure = abs((after2 - after) - right) <= 0.1 * abs(right) + rounding;
    vec2 steps = vec2(left, right);
    if (leftSure != rightSure) return Slope(leftSure ? left : right, true, steps);
    float less = abs(left) < abs(right) ? left : right;
    return Slope(left * right > 0.0 || leftSure ? less : 0.0, leftSure, steps);
}

float signedDepthAt(const MirrorBlock mirror, vec2 pixel) {
    return signedDepth(mirror, depthAt(mirror, clamp(pixel, vec2(0.0), vec2(regionSize(mirror)) - 0.5)));
}

Slope slopeAlong(const MirrorBlock mirror, vec2 pixel, vec2 step, float here) {
    return slopeOf(mirror, signedDepthAt(mirror, pixel - 2.0 * step), signedDepthAt(mirror, pixel - step), here,
                   signedDepthAt(mirror, pixel + step), signedDepthAt(mirror, pixel + 2.0 * step));
}

// A stretch of a track over one pixel, in which the ray goes behind what is seen there.
struct Crossing {
    bool found;
    float share;    // at which the ray meets that
    vec3 shown;     // where that shows: pixel, and the ray's signed depth there
    float begins;   // as shares
    float ends;
    bool close;     // the ray is no farther behind it than things are thick
    bool thin;      // what the ray passes behind there
    float coveredFrom;   // share from which on something nearer than what is seen there hid the ray; else `inSight`
};

const float inSight = 2.0;
const Crossing noCrossing = Crossing(false, 0.0, vec3(0.0), 0.0, 0.0, false, false, inSight);

// Whether the ray, a pixel before, was in front of something by less than it may be behind it: at an edge it met the one
// face, and the pixel shows the other.
bool cameCloseTo(Track track, float share) {
    float before = max(share - 2.0 * track.halfPixel, 0.0);
    vec3 point = trackPoint(track, before);
    Seen seen = seenAt(track.scene, pixelAt(track.scene, point.xy));
    return seen.counts && seen.depth <= point.z && within(track, before, seen.depth, point.z);
}

// What a crossing is worth.
const int refused = 0;
const int unseen = 1;    // the ray, hidden by something nearer, has met what shows beside that
const int behind = 2;    // the ray passes behind what is seen; it meets it if that is thick
const int closely = 3;   // by no more than that is wide
const int underside = 4; // the ray comes out of what is seen, and so has met a side that is not
const int met = 5;

// How far a ray is behind what is seen, in the pixels that so many metres cover there.
float pixelsBehind(Track track, float share, float ray, float seen) {
    vec2 here = track.weights.xz + share * track.weights.yw;
    vec3 row = vec3(settings.pixelFromRelative[0].y, settings.pixelFromRelative[1].y, settings.pixelFromRelative[2].y);
    float deeper = seen - ray;
    return deeper * here.y * length(row) / (here.x + track.scene.weightPerDepth * deeper);
}

// Whether a ray is hidden still, so many pixels farther along it on the screen.
bool staysHidden(Track track, float share, float pixels) {
    float after = min(share + 2.0 * track.halfPixel * pixels, 1.0);
    vec3 point = trackPoint(track, after);
    Seen seen = seenAt(track.scene, pixelAt(track.scene, point.xy));
    return seen.counts && seen.depth >= point.z;
}

// Whether what is seen at a pixel goes on as a plane as far as another.
bool goesOn(const MirrorBlock mirror, Scene scene, vec2 pixel, float seen, vec2 slope, vec2 other) {
    float rise = dot(slope, other - pixel);
    Seen there = seenAt(scene, pixelAt(scene, other));
    return there.counts && abs(there.depth - seen - rise) <= 0.1 * abs(rise) + 2.0 * roundingAt(mirror, seen);
}

// Whether what is seen goes on for two pixels along the ray, as rails and ropes do not.
bool isBroad(Track track, float share, float seen) {
    float after = min(share + 4.0 * track.halfPixel, 1.0);
    vec3 point = trackPoint(track, after);
    float there = seenAt(track.scene, pixelAt(track.scene, point.xy)).depth;
    return within(track, after, point.z, min(there, seen), max(there, seen));
}

// Where the ray is, or is nearest to the pixel by which it was met, if what lies under the plane's horizon shows beside that.
// Sky beside it softens the outline.
vec3 shownIn(Track track, float share, vec2 middle) {
    vec3 point = trackPoint(track, share);
    ivec2 pixel = pixelAt(track.scene, point.xy);
    float depth = texelFetch(sceneDepth, track.scene.origin + pixel, 0).r;
    if (dot(track.scene.aboveRow, vec4(vec2(pixel) + 0.5, depth, 1.0)) > 0.0) return point;
    return vec3(clamp(point.xy, middle - 0.49, middle + 0.49), point.z);
}

// Whether a ray that passes below what is seen rises into it: where it is as high, it is farther away by no more than things are
// thick. Below what hovers it may leave.
bool risesInto(const MirrorBlock mirror, Track track, float share, vec2 pixel, float depth) {
    vec4 seen = vec4(pixel, signedDepth(mirror, depth), 1.0);
    vec4 over = rowOver(mirror, heightOf(mirror, seen));
    vec4 first = vec4(track.first.xy, signedDepth(mirror, track.first.z), 1.0);
    vec4 along = vec4(track.along.xy, signedDepth(mirror, track.along.z), 0.0);
    float rises = dot(over, along);
    float enters = rises > 0.0 ? -dot(over, first) / rises : share;
    vec4 ray = first + max(enters, share) * along;
    float farther = dot(settings.forwardRow, seen) / weightOf(mirror, seen) + track.scene.thickness;
    return dot(settings.forwardRow, ray) <= farther * weightOf(mirror, ray);
}

// Moves a crossing to where the ray meets the plane through what is seen: while it was hidden before, too. Where the ray
// leaves that plane towards the eye instead, what shows is the far side of what it met before: an underside where the plane
// goes on as far as that.
int settled(const MirrorBlock mirror, Track track, inout Crossing crossing) {
    vec3 point = trackPoint(track, crossing.share);
    vec2 middle = floor(min(point.xy, vec2(regionSize(mirror)) - 0.5)) + 0.5;
    Seen here = seenAt(track.scene, ivec2(middle));
    if (!here.counts) return refused;
    float seen = here.depth;
    Slope x = slopeAlong(mirror, middle, vec2(1.0, 0.0), seen);
    Slope y = slopeAlong(mirror, middle, vec2(0.0, 1.0), seen);
    vec2 slope = vec2(x.perPixel, y.perPixel);
    float above = point.z - seen - dot(slope, point.xy - middle);
    float perShare = track.along.z - dot(slope, track.along.xy);
    float rounding = roundingAt(mirror, seen) / track.halfPixel;
    bool wide = x.sure && y.sure;
    // By the steps to whichever side.
    vec2 most = max(vec2(x.steps.x, y.steps.x) * track.along.xy, vec2(x.steps.y, y.steps.y) * track.along.xy);
    float leaving = wide ? perShare : track.along.z - most.x - most.y;
    float meets = crossing.share - above / (abs(perShare) > 0.0 ? perShare : 1.0);
    // Only while it was hidden can it have met what shows beside, since before it was seen not to.
    bool covered = meets >= crossing.coveredFrom && meets <= crossing.begins;
    if (covered && perShare < -rounding && isBroad(track, crossing.share, seen)) {
        crossing.shown = shownIn(track, crossing.share, middle);
        crossing.share = meets;
        return crossing.close ? closely : unseen;
    }
    if (!crossing.close) return refused;
    bool cameClose = cameCloseTo(track, crossing.begins);
    bool leaves = leaving > rounding && !cameClose;
    crossing.share = clamp(meets, max(crossing.begins, 0.0), min(crossing.ends, 1.0));
    crossing.shown = shownIn(track, crossing.share, middle);
    float beside = abs(meets - crossing.share);
    if (leaves && beside <= 3.0 * track.halfPixel) return underside;
    if (leaves && wide) {
        if (meets > 1.0) return refused;
        crossing.share = meets;
        crossing.shown = trackPoint(track, meets);
        return goesOn(mirror, track.scene, middle, seen, slope, floor(crossing.shown.xy) + 0.5) ? underside : refused;
    }
    // Half a pixel beside, since an edge falls anywhere in its pixel.
    if (beside <= track.halfPixel) return met;
    // Things are taken to be at most twice as thick as wide, which two looks along the ray tell: the second may fall on
    // what stands beside. What is too narrow to tell its slope is taken to be as thick as two pixels.
    float pixels = pixelsBehind(track, crossing.share, trackPoint(track, crossing.share).z, seen);
    crossing.thin = pixels <= 2.0;
    if (crossing.thin || wide && cameClose) return closely;
    bool thick = wide && risesInto(mirror, track, crossing.share, middle, seen) && staysHidden(track, crossing.share, 0.25 * pixels) &&
                 staysHidden(track, crossing.share, 0.5 * pixels);
    if (!thick) return refused;
    return staysHidden(track, crossing.share, pixels) ? closely : behind;
}

// Whether the far plane shows where the ray was left and where it would end.
bool reachesSky(const MirrorBlock mirror, Track track, vec4 perMetre) {
    vec3 last = trackPoint(track, 1.0);
    // Where lines of sight are parallel, it ends at the far plane.
    bool parallel = perMetre.w == 0.0;
    if (parallel ? last.z > track.scene.far + 1e-5 : perMetre.w < 0.0) return false;
    vec2 end = parallel ? last.xy : perMetre.xy / perMetre.w;
    if (!insideRegion(mirror, end) || !insideRegion(mirror, last.xy)) return false;
    return isFar(mirror, depthAt(mirror, end)) && isFar(mirror, depthAt(mirror, last.xy));
}

// What hides a ray for a while.
struct Cover {
    float depth;   // signed, at the last sample; `nothing` while the ray is in sight
    float from;    // share from which on it hides the ray
};

const float nothing = -2.0;
const Cover noCover = Cover(nothing, 0.0);

// Whether what hides a ray ends at a sample that began at `share`, and what shows there instead lies behind it by more than things
// are thick, and still before the ray.
bool coverEnds(Track track, float share, float ray, Seen seen, bool isBehind, inout Cover cover) {
    bool ends = isBehind && cover.depth != nothing && !within(track, share, ray, seen.depth, cover.depth);
    cover.from = cover.depth == nothing ? share : cover.from;
    cover.depth = isBehind ? seen.depth : nothing;
    return ends;
}

// How far a ray has been followed.
struct Progress {
    float reached;   // share
    bool inFront;    // of what is seen there
    bool hidden;     // was behind something
    Cover cover;
    int taps;       // left
};

struct March {
    float info;
    vec3 source;   // pixel at which the hit shows, and how near the ray is there, from infinityDepth
    int worth;
};

#endif
