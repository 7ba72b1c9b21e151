// What shines through the surface from below it.
#ifndef REFRACTION_GLSL
#define REFRACTION_GLSL

#include "surface_fog.glsl"
#include "near_plane.glsl"
#include "surface_point.glsl"
#include "scene_behind.glsl"
#include "surface_fresnel.glsl"
#include "lit_below.glsl"
#include "water_light.glsl"
#include "texel_at.glsl"
#include "turns.glsl"

const bool hasBed = bedDownscale > 0;

// In what follows pixels are the bed's where it has a picture of its own: wider than the region, from a raised
// eye (water/below/bed.cpp), and with nothing in it that stands above the water. Else they are the scene's.
vec4 bedPixelOf(vec4 relative) {
    return hasBed ? water.bedFromRelative * relative : homogeneousPixel(relative);
}

Behind bedAt(vec2 pixel) {
    if (!hasBed) return behindAt(pixel);
    vec2 p = pointWithin(pixel, water.bedSize.xy);
    float depth = texelFetch(bedDepth, ivec2(p), 0).r;
    return shownAt(p, depth, water.relativeFromBed * vec4(floor(p) + 0.5, depth, 1.0));
}

// Where what a pixel shows is looked at: its middle.
vec2 middleOf(Behind b) {
    return floor(b.pixel) + 0.5;
}

// Linear, of the four around that show something: the others may hold whatever memory held.
vec4 betweenBedTexels(vec2 pixel) {
    vec2 corner = floor(pixel - 0.5);
    vec2 past = pixel - 0.5 - corner;
    vec4 depths = textureGather(bedDepth, (corner + 1.0) / vec2(water.bedSize.xy));
    vec4 weights = vec4(1.0 - past.x, past.x, past.x, 1.0 - past.x) * vec4(past.y, past.y, 1.0 - past.y, 1.0 - past.y);
    const ivec2 places[4] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(0, 0));
    vec4 sum = vec4(0.0);
    float all = 0.0;
    [[dont_unroll]] for (int i = 0; i < 4; ++i) {
        if (weights[i] <= 0.0 || isFarPlane(depths[i])) continue;
        sum += weights[i] * linearTexel(texelFetch(bedColor, clamp(ivec2(corner) + places[i], ivec2(0), water.bedSize.xy - 1), 0));
        all += weights[i];
    }
    return sum / max(all, 1e-6);
}

vec4 bedColorOf(Behind b) {
    if (!hasBed) return colorOf(b);
    return bedDownscale > 1 ? betweenBedTexels(b.pixel) : linearTexel(texelFetch(bedColor, ivec2(b.pixel), 0));
}

// What shows where a bent ray has come to, `target` in homogeneous pixels, from `here`.
Behind behindRay(vec2 here, vec4 target) {
    return bedAt(mix(here, target.xy / target.w, water.refractionDistortion));
}

const float sharpBed = bedDownscale > 1 ? 1.5 : 0.5;   // a blur of so many pixels is none: between texels there is some

bool isBelowWater(const SurfacePoint s, Behind b) {
    return !b.nothing && b.seen.y < min(s.position.y, calmLevel());
}

// Where the ray that a slope bends goes on each metre down.
const float shallowest = 0.1;   // of its way

vec3 bentPerDepth(vec2 slope, vec3 toEye) {
    vec3 bent = refract(-toEye, normalOf(slope), 1.0 / waterIndex);
    return bent / max(-bent.y, shallowest);
}

// Whether the bed beyond the border goes on from a survey of what shows before it, rather than from the last pixel alone.
const bool surveysBed = refractionSamples > 3;

// A bed that goes on as a plane.
struct BedPlane {
    vec3 place;   // of it, relative to the eye
    vec2 slope;
};

float heightAbove(BedPlane plane, vec3 place) {
    return place.y - plane.place.y - dot(plane.slope, place.xz - plane.place.xz);
}

// The strides of a survey [pixels].
float strideOnBed() {
    return 0.06 * float(hasBed ? water.bedSize.y : regionSize().y);
}

// The median height of what shows at a pixel and beside it, across the track: a mast, a rope or a leaf is no bed.
float heightAround(const SurfacePoint s, Behind b, vec2 track) {
    vec2 aside = strideOnBed() * vec2(-track.y, track.x);
    vec2 lows = vec2(1e9), highs = vec2(-1e9);   // the two least, and the two most
    [[dont_unroll]] for (int i = 0; i < 4; ++i) {
        Behind there = bedAt(middleOf(b) + 0.5 * float(i < 2 ? i - 2 : i - 1) * aside);
        float height = isBelowWater(s, there) ? there.seen.y : b.seen.y;
        lows = vec2(min(lows.x, height), min(lows.y, max(lows.x, height)));
        highs = vec2(max(highs.x, height), max(highs.y, min(highs.x, height)));
    }
    return clamp(b.seen.y, lows.y, highs.y);
}

// The lesser of two slopes; none where they differ in sign.
vec2 lesserSlope(vec2 a, vec2 b) {
    if (dot(a, b) <= 0.0) return vec2(0.0);
    return dot(a, a) < dot(b, b) ? a : b;
}

// The slope from `before` to `last`. Steps are no bed, nor are the sides of stones.
vec2 slopeBetween(const SurfacePoint s, Behind before, Behind last) {
    vec3 step = last.seen - before.seen;
    float across = dot(step.xz, step.xz);
    bool isSlope = isBelowWater(s, before) && step.y * step.y < 0.25 * across;
    return isSlope ? step.xz * (step.y / across) : vec2(0.0);
}

// How the bed goes on beyond its last pixel; `track` is the way of rays on the screen, unit. A survey goes on with medians of heights:
// of the last pixel, then of one a stride before.
BedPlane bedBeyond(const SurfacePoint s, inout Behind last, vec2 track, bool isSurveyed) {
    vec2 middle = middleOf(last);
    BedPlane plane;
    int i = 0;
    // All share one copy of the code.
    [[dont_unroll]] do {
        Behind there = bedAt(middle - (i == 0 ? 4.0 : strideOnBed()) * track);
        if (i == 1) there = last;
        if (i > 0) there.seen.y = heightAround(s, there, track);
        // Without the first condition Mesa 22.3's llvmpipe changes what has left the loop.
        if (isSurveyed && i == 1) last.seen.y = there.seen.y;
        vec2 slope = slopeBetween(s, there, last);
        if (i == 0) plane.slope = slope;
        if (isSurveyed && i == 2) plane.slope = lesserSlope(plane.slope, slope);
    } while (surveysBed && ++i < (isSurveyed ? 3 : 1));
    plane.place = last.seen;
    return plane;
}

// The depth at which a ray that goes `perDepth` a metre down meets a bed that goes on as that plane does.
float depthBeyond(const SurfacePoint s, vec3 perDepth, BedPlane plane) {
    float depth = heightAbove(plane, s.position) / max(1.0 + dot(plane.slope, perDepth.xz), 0.2);
    return clamp(depth, 0.0, 1.5 * (s.position.y - plane.place.y));
}

// Where the bed has no picture of its own, the scene's may show it in part, or things that float over none. So the ray is
// looked for in steps first, of so many pixels at the least. A shore has its map.
const int sceneSamples = hasShore || hasBed || refractionSamples == 1 ? 0 : 2 * refractionSamples + 4;
const float sceneStride = 2.0;

// As much depth as can be seen through [m].
float seenAsFarAs() {
    vec3 k = extinction();
    return 2.0 / min(min(k.r, k.g), k.b);
}

// The depth at which a ray meets the bed that the shore's map has.
float depthOnMap(const SurfacePoint s, vec3 perDepth) {
    float depth = s.height + s.shore.depth;
    return clamp(depth / max(1.0 + dot(s.shore.bedSlope, perDepth.xz), 0.2), 0.0, 3.0 * max(depth, 0.0));
}

// How much nearer the ray, which is `at` that pixel, is than the scene behind it: in what is affine on the screen of both,
// inverse distances from an eye, and distances along parallel lines of sight.
float nearerBy(vec4 pixel, vec3 at, Behind b) {
    float scene = bedPixelOf(vec4(b.seen, 1.0)).w;
    float endless = (seenFromAnEye() - 1.0) * 1e4;
    return 1.0 / pixel.w - alongParallels(at) - (b.nothing ? endless : 1.0 / scene - alongParallels(b.seen));
}

// Along the edge of what stands before the surface sample 0 of a pixel may be that thing's: the pixel beside it that shows what
// lies behind.
vec2 besideWhatHides(const SurfacePoint s, vec2 here) {
    const ivec2 beside[5] = ivec2[](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
    int i = 0;
    [[dont_unroll]] do {
        Behind b = behindAt(here + beside[i]);
        if (b.nothing || isBelowWater(s, b)) return here + beside[i];
    } while (++i < 5);
    return here;
}

// Of the places of a Gaussian [deviations] that the pixels of a quad look at together, one of this pixel's `taps`, 1 or 4: for
// each a square, one corner a pixel, so that their mean is 0, and the variance of 16 is 1 along any axis.
vec2 placeAround(int tap, int taps) {
    const float radii[4] = float[](0.540, 1.013, 1.463, 2.131);
    float radius = taps == 1 ? 1.25 : radii[tap];   // four places alone blur more than a Gaussian
    return radius * cosineSine(0.0637 + 0.3125 * float(tap) + dot(partOfQuad(), vec4(0.0, 0.25, 0.5, 0.75)));
}

// How far a deviation of the slopes within the pixel moves to the side what a ray comes to on each metre down, and one aside of that.
mat2 straysPerDepth(const SurfacePoint s, vec3 toEye) {
    if (!hasWaves) return mat2(0.0);
    float u = sqrt(max(s.covariance.x, 1e-12));
    float both = s.covariance.z / u;
    vec2 deviation = vec2(u, both);
    vec2 mean = bentPerDepth(s.slope, toEye).xz;
    mat2 strays = mat2(0.0);
    int i = 0;
    [[dont_unroll]] do {
        strays[0] = strays[1];
        strays[1] = bentPerDepth(s.slope + deviation, toEye).xz - mean;
        deviation = vec2(0.0, sqrt(max(s.covariance.y - both * both, 0.0)));
    } while (++i < 2);
    return strays;
}

// The same of what is seen of a bed `drop` metres below [pixels].
mat2 blurOfBed(mat2 strays, Behind b, float drop) {
    if (!hasWaves) return mat2(0.0);
    vec2 middle = middleOf(b);
    mat2 blur = mat2(0.0);
    int i = 0;
    [[dont_unroll]] do {
        vec4 there = bedPixelOf(vec4(b.seen + drop * vec3(strays[0].x, 0.0, strays[0].y), 1.0));
        blur[0] = blur[1];
        blur[1] = there.w > 0.0 ? water.refractionDistortion * (there.xy / there.w - middle) : vec2(0.0);
        strays[0] = strays[1];
    } while (++i < 2);
    return blur;
}

float widthOf(mat2 blur) {
    return sqrt(dot(blur[0], blur[0]) + dot(blur[1], blur[1]));
}

// Where a mean of the bed is taken.
// At how many points of its way into the water light through crests is taken.
int pointsLit() {
    return clamp(refractionSamples / 2, 1, 3);
}

struct BedTaps {
    bool isBeyond;     // of what lies beyond the border
    int count;         // of those that are to show the bed, beside the bed's own pixel
    int most;          // looked at for them: more, where the bed is surveyed
    vec2 middle;       // [pixel]
    mat2 blur;         // around that
};

const int tapsAround = refractionSamples > 3 ? 4 : 1;

// Of what those slopes show of the bed around, or of the pixel alone.
BedTaps bedAround(Behind b, mat2 blur, float blurred) {
    int count = blurred > sharpBed ? tapsAround : 0;
    return BedTaps(false, count, count, hasBed ? b.pixel : b.pixel + 0.5, blur);
}

// What lies beyond the border nobody knows: a mean of the bed around the place that lies as far inside, over a wider part of
// it the farther out, and `least` pixels wide. So the bed goes on without a seam, a streak or rocks where there are none.
BedTaps bedBeyondBorder(Behind inside, vec3 beyond, vec2 here, float least, bool isSurveyed) {
    vec4 p = bedPixelOf(vec4(2.0 * inside.seen - beyond, 1.0));
    vec2 middle = mix(here, p.xy / p.w, water.refractionDistortion);
    float radius = max(length(middle - middleOf(inside)), least);
    // Where a quad's mean is taken, each pixel of a tile looks at places of its own, in an order by which those beside each other differ
    // most: where all look at the same, what stands out there is drawn out to streaks.
    float turned = least > sharpBed ? 0.5 * ldexp(float(bitfieldReverse(indexInTile())), -32) : 0.0;
    vec2 along = radius * cosineSine(turned);
    int count = p.w > 0.0 ? 4 : 0;
    return BedTaps(true, count, isSurveyed ? 4 * count : count, middle, mat2(along, -along.y, along.x));
}

// A place of four; then of these turned, and farther out; and so on.
vec2 placeBeyond(int i) {
    const vec2 places[4] = vec2[](vec2(0.45, -0.35), vec2(-0.5, 0.4), vec2(0.85, 0.7), vec2(-0.8, -0.75));
    vec2 place = places[i & 3];
    if (!surveysBed) return place;
    float past = float(i >> 2);
    vec2 turned = cosineSine(0.11 * past);
    return (1.0 + 0.1 * past) * mat2(turned, -turned.y, turned.x) * place;
}

// Across the border it is as it is inside.
vec2 tapOf(BedTaps taps, int i) {
    vec2 off = taps.blur * (taps.isBeyond ? placeBeyond(i) : placeAround(i & 3, tapsAround));
    vec2 pixel = taps.middle + off;
    vec2 size = vec2(hasBed ? water.bedSize.xy : regionSize());
    bool isOutside = any(lessThan(pixel, vec2(0.0))) || any(greaterThanEqual(pixel, size));
    return isOutside && !taps.isBeyond ? taps.middle - off : pixel;
}

const float standsUp = 0.15;      // from the bed, of its depth
const float hardlyCounts = 1e-12;   // beside 1 it is lost, and alone it is all there is

bool isSteep(Behind there, vec2 pixel) {
    vec3 step = bedAt(pixel - vec2(0.0, 1.0)).seen - there.seen;
    return abs(step.y) >= 0.5 * length(step.xz);
}

// How much a tap counts that shows what rises so far above the bed at `b`, which is `drop` metres below. Beyond the border what stands
// up from the bed is not it; what lies lower than the last pixel before is, which may show a stone. Steep ground may be a stone's side:
// where the bed is surveyed it counts where there is no other.
float countsAs(const SurfacePoint s, BedTaps taps, Behind b, float drop, Behind there, vec2 pixel, float rise) {
    bool isBed = isBelowWater(s, there);
    if (taps.isBeyond) isBed = isBed && rise < standsUp * (s.position.y - b.seen.y);
    else isBed = isBed && length(there.seen - b.seen) <= 0.5 * drop;
    float steep = surveysBed && !hasBed && taps.most > taps.count ? hardlyCounts : 0.0;
    bool isStone = isBed && taps.isBeyond && isSteep(there, pixel);
    return isStone ? steep : isBed ? 1.0 : 0.0;
}

// The plane of a bed that is surveyed becomes as high as the taps are, and level where these are not on it.
vec4 bedColorBy(const SurfacePoint s, BedTaps taps, Behind b, float drop, inout BedPlane plane) {
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    bool isSurveyed = surveysBed && taps.most > taps.count;
    float depth = s.position.y - b.seen.y;
    Behind there = b;
    float weight = taps.count > 0 ? 1e-3 : 1.0;
    if (isSurveyed && isSteep(b, middleOf(b))) weight = hardlyCounts;
    float above = isSurveyed ? heightAbove(plane, b.seen) : 0.0, rise = 0.0, height = 0.0;   // over the plane, its sum, and that over the eye
    int i = 0;
    // The bed's own pixel first, so that all share one copy of what looks colour up.
    [[dont_unroll]] do {
        vec4 color = bedColorOf(there);
        // Without the second condition Mesa 22.3's llvmpipe adds to the sums of invocations that have left the loop.
        if (weight > 0.0 && i <= taps.most) {
            // What was taken for the bed stands up from what shows here.
            if (isSurveyed && weight == 1.0 && rise - weights * above > standsUp * depth * weights) {
                sum = vec4(0.0);
                weights = rise = height = 0.0;
            }
            sum += weight * color;
            rise += weight * above;
            height += weight * there.seen.y;
            weights += weight;
        }
        vec2 pixel = tapOf(taps, i);
        there = bedAt(pixel);
        above = isSurveyed ? heightAbove(plane, there.seen) : there.seen.y - b.seen.y;
        weight = countsAs(s, taps, b, drop, there, pixel, above - (isSurveyed ? min(rise / weights, 0.0) : 0.0));
    } while (++i <= taps.most && weights < float(taps.count));
    if (!isSurveyed) return sum / weights;
    rise /= weights;
    float level = smoothstep(0.05, 0.1, abs(rise) / max(depth, 1e-3));
    plane.place.y = mix(plane.place.y + rise, height / weights, level);
    plane.slope *= 1.0 - level;
    return sum / weights;
}

// What shines through.
struct Through {
    vec3 radiance;   // through the air before the surface
    float path;      // metres of water before it
    float blurred;   // pixels over which slopes too small to be seen spread it
};

const float endlessPath = 1e6;   // [m]

Through endlessWater(const SurfacePoint s) {
    return Through(throughAir(endlessGlow(sunDirection(s)), s.air), endlessPath, 0.0);
}

// A bed of so much light in air, at so much depth.
Through bedThrough(const SurfacePoint s, vec3 bed, float depth, float gathered, float path) {
    vec3 through = litBelow(sunDirection(s), bed, depth, gathered) / (waterIndex * waterIndex) * exp(-extinction() * path);
    vec3 seen = sceneThroughAir(through, through / max(bed, 1e-9), s.air);
    return Through(seen + throughAir(waterGlow(sunDirection(s), vec3(path)), s.air), path, 0.0);
}

// Whether a ray meets what shows between two depths, where it lies before that and behind it, rather than to pass behind its
// edge. `bed` is how high what shows at the second lies; `depth` is the second, and becomes that of the place.
bool meetsBetween(const SurfacePoint s, vec4 from, vec4 perDepth, vec2 here, float before, float bed, inout float depth) {
    const int halvings = 5;
    const float mostOff = 0.04;   // of the depth
    int i = 0;
    [[dont_unroll]] do {
        float middle = 0.5 * (before + depth);
        Behind b = behindRay(here, from + perDepth * middle);
        bool isUnder = isBelowWater(s, b) && s.position.y - b.seen.y < middle;
        if (isUnder) bed = b.seen.y;
        if (isUnder) depth = middle;
        else before = middle;
    } while (++i < halvings);
    return depth - (s.position.y - bed) < mostOff * depth + 2.0 * (depth - before);
}

// The ray that Snell's law bends, in homogeneous pixels.
struct BentRay {
    vec2 here;         // the pixel it leaves the surface at
    vec4 from;
    vec4 perDepth;     // on each metre down
    vec3 direction;    // likewise, in metres
    mat2 strays;       // straysPerDepth()
    float leaves;      // the depth at which it leaves the picture
    bool passedOver;   // nothing shows where the line of sight goes on
    float onMap;       // the depth at which it meets the bed of a shore's map
};

// A sample along it: the depth at which it was, 0 where the line of sight goes on, and whether it showed what is below water. What it
// showed is looked up again where that is needed: kept meanwhile, it takes GPUs five registers.
struct RaySample {
    float depth;
    bool isBed;
};

// What has been found of the bed along it.
struct BedFound {
    RaySample found;
    float sought;   // the depth to sample next
    RaySample nearest;   // of the bed, where the ray is under what shows
    RaySample last;      // of the bed, before the ray leaves the picture or passes behind something
    float deepest;   // at which the ray was seen to be above the bed
    float least;     // by how much its depth and the bed's differ at `found`; `unmet`: it was looked for nowhere yet
    bool met;
    bool left;       // the picture
};

BentRay bentRay(const SurfacePoint s, vec3 normal, vec3 toEye) {
    BentRay ray;
    vec3 bent = refract(-toEye, normal, 1.0 / waterIndex);
    ray.direction = bent / max(-bent.y, shallowest);
    ray.strays = straysPerDepth(s, toEye);
    ray.from = bedPixelOf(vec4(s.position, 1.0));
    ray.perDepth = bedPixelOf(vec4(ray.direction, 0.0));
    ray.here = hasBed ? ray.from.xy / ray.from.w : s.pixel;
    if (manySamples && !hasBed) ray.here = besideWhatHides(s, ray.here);
    ray.leaves = untilBorder(ray.from, ray.perDepth, vec2(hasBed ? water.bedSize.xy : regionSize()));
    ray.onMap = hasShore ? depthOnMap(s, ray.direction) : 0.0;
    ray.passedOver = false;
    return ray;
}

Behind behindRayAt(BentRay ray, float depth) {
    return behindRay(ray.here, ray.from + ray.perDepth * depth);
}

const float unmet = 1e9;

Behind shownBy(BentRay ray, RaySample at) {
    return at.depth > 0.0 ? behindRayAt(ray, at.depth) : bedAt(ray.here);
}

// `nothing`: the far plane is all that shows.
BedFound foundFirst(const SurfacePoint s, BentRay ray, Behind straight, out bool nothing) {
    BedFound bed;
    bed.found = RaySample(0.0, isBelowWater(s, straight));
    nothing = straight.nothing;
    bed.sought = min(max(s.position.y - straight.seen.y, 0.0), ray.leaves);
    if (ray.passedOver) {
        bed.sought = min(seenAsFarAs(), ray.leaves);
        Behind below = behindRayAt(ray, bed.sought);
        bed.found = RaySample(bed.sought, isBelowWater(s, below));
        nothing = below.nothing;
        if (bed.found.isBed) bed.sought = min(max(s.position.y - below.seen.y, 0.0), bed.sought);
        if (hasShore) bed.sought = min(ray.onMap, ray.leaves);
    }
    bed.nearest = bed.last = bed.found;
    bed.deepest = 0.0;
    bed.least = unmet;
    bed.met = bed.left = false;
    return bed;
}

// Looks for the ray in the scene in even steps of the screen. False where it meets nothing, and nothing else is seen there.
bool meetsScene(const SurfacePoint s, BentRay ray, inout BedFound bed) {
    float farthest = bed.sought;
    Behind end = behindRayAt(ray, farthest);
    bool endless = end.nothing;
    RaySample other = bed.last;   // what is seen where the ray does not meet what the line of sight does
    if (endless || s.position.y - end.seen.y > 1.1 * farthest) {
        farthest = min(2.0 * seenAsFarAs(), ray.leaves);
        Behind there = behindRayAt(ray, farthest);
        other = RaySample(farthest, isBelowWater(s, there));
        endless = farthest < ray.leaves || there.nothing;
        bed.sought = farthest;
    }
    vec4 goal = ray.from + ray.perDepth * farthest;
    int taps = min(int(length(goal.xy / goal.w - ray.here) / sceneStride), sceneSamples);
    float before = 0.0;
    bool wasUnder = false;
    int k = 1;
    [[dont_unroll]] while (k < taps && !bed.met) {
        float share = float(k++) / float(taps);
        float depth = share * farthest * ray.from.w / mix(goal.w, ray.from.w, share);
        Behind b = behindRayAt(ray, depth);
        bool isUnder = isBelowWater(s, b) && s.position.y - b.seen.y < depth;
        if (isUnder && !wasUnder) {
            float met = depth;
            bed.met = meetsBetween(s, ray.from, ray.perDepth, ray.here, before, b.seen.y, met);
            bed.found = RaySample(met, true);
        }
        wasUnder = isUnder;
        before = depth;
    }
    if (endless && !bed.met) return false;
    if (!bed.met) bed.found = bed.last = other;
    return true;
}

// By false position, from what the line of sight shows.
void findRoot(const SurfacePoint s, BentRay ray, float nearerFirst, inout BedFound bed) {
    // Of its depth, from what is met; with two samples the nearest is the best there is.
    const float mostOff = refractionSamples > 2 ? 0.35 : 1e9;
    vec2 above = vec2(0.0, nearerFirst);   // a way on the screen, and how much nearer the ray is there
    vec2 under = vec2(0.0);                // likewise, where it is not; none while its second is 0
    int i = 0;
    do {
        vec4 target = ray.from + ray.perDepth * bed.sought;
        Behind b = behindRay(ray.here, target);
        float deeper = b.nothing ? max(bed.sought, 1.0) : s.position.y - b.seen.y - bed.sought;
        bool isBed = isBelowWater(s, b);
        if (isBed && abs(deeper) < min(bed.least, mostOff * bed.sought)) {
            bed.least = abs(deeper);
            bed.found = RaySample(bed.sought, true);
        }
        // Its sign is that of what can be told more exactly.
        float nearer = nearerBy(target, s.position + ray.direction * bed.sought, b);
        vec2 reached = vec2(bed.sought / target.w, deeper > 0.0 ? max(nearer, 1e-9) : min(nearer, -1e-9));
        vec2 before = above;
        if (deeper > 0.0) {
            above = reached;
            bed.deepest = bed.sought;
            if (isBed) bed.last = RaySample(bed.sought, true);
        } else {
            if (isBed) bed.nearest = RaySample(bed.sought, true);
            // Of what stands before the bed only that it does counts.
            under = isBed ? reached : vec2(reached.x, -above.y);
        }
        bed.left = deeper > 0.01 && bed.sought >= ray.leaves;
        vec2 other = under.y < 0.0 ? under : before;
        float apart = other.x - above.x;
        float slope = abs(apart) > 1e-9 ? (other.y - above.y) / apart : 0.0;
        float way = above.x - above.y / min(slope, -1e-9);
        if (under.y < 0.0) way = clamp(way, mix(above.x, under.x, 0.02), mix(above.x, under.x, 0.98));
        float beyond = 1.0 - way * ray.perDepth.w;
        // Two samples that lie close together tell the slope no better than texels do.
        float farthest = i > 0 ? min(4.0 * bed.sought, ray.leaves) : ray.leaves;
        bed.sought = beyond > 0.0 ? min(way * ray.from.w / beyond, farthest) : farthest;
    } while (++i < refractionSamples - 1 && bed.least > 0.01 && !bed.left);
}

// Where the ray leaves the picture, or passes behind something, the bed goes on by its slope. Whether that had to be made up; `shown` is
// what shows, or the last that did, and `drop` how deep it lies under the surface along the ray.
bool goesOnBeyond(const SurfacePoint s, BentRay ray, const BedFound bed, out Behind shown, out float drop, out BedPlane plane) {
    const float wellOff = refractionSamples > 3 ? 0.05 : 0.35;
    bool astray = refractionSamples > 2 && !ray.passedOver && !bed.met && bed.least > wellOff * bed.found.depth && bed.found.isBed;
    bool goesOn = (bed.left || astray) && bed.last.isBed;
    shown = shownBy(ray, goesOn ? bed.last : bed.found);
    drop = bed.met || bed.least < unmet ? bed.found.depth : max(s.position.y - shown.seen.y, 0.0);
    plane = BedPlane(vec3(0.0), vec2(0.0));
    if (!goesOn) return false;
    vec2 track = ray.perDepth.xy - ray.perDepth.w * ray.from.xy / ray.from.w;
    plane = bedBeyond(s, shown, track / max(length(track), 1e-6), surveysBed && bed.left);
    drop = max(depthBeyond(s, ray.direction, plane), bed.deepest);
    Behind there = behindRayAt(ray, drop);
    bool met = drop < ray.leaves && isBelowWater(s, there) && abs(s.position.y - there.seen.y - drop) < 0.1 * drop;
    if (met) shown = there;
    return !met;
}

// Of what was found of it. `known`: how much of what shows is the bed, and not what nobody knows.
Through throughBed(const SurfacePoint s, BentRay ray, const BedFound bed, inout float known) {
    // What hides the place that the ray meets is as good as it, unless it lies far higher.
    known = ray.passedOver && !bed.met && !(bed.left && bed.last.isBed)
        ? 1.0 - smoothstep(0.4, 0.9, bed.least / max(bed.found.depth, 1e-3)) : 1.0;
    Behind found;
    float drop;
    BedPlane plane;
    bool madeUp = goesOnBeyond(s, ray, bed, found, drop, plane);
    bool isSurveyed = surveysBed && madeUp && bed.left;
    mat2 blur = blurOfBed(ray.strays, found, drop);
    float blurred = widthOf(blur);
    BedTaps taps = bedAround(found, blur, blurred);
    if (madeUp) taps = bedBeyondBorder(found, s.position + ray.direction * drop, ray.here, blurred, isSurveyed);
    vec4 color = bedColorBy(s, taps, found, drop, plane);
    if (isSurveyed) {
        found.seen = plane.place;
        drop = max(depthBeyond(s, ray.direction, plane), bed.deepest);
    }
    float wayPerDepth = length(ray.direction);
    float path = mix(length(found.seen - s.position), drop * wayPerDepth, water.refractionDistortion);
    float depth = -heightOverCalm(found.seen);
    bool isSure = !(hasShore && ray.passedOver) || known >= 1.0;
    vec3 mean = vec3(0.0);
    float share = isSure ? 1.0 : known;
    Through through;
    int i = 0;
    [[dont_unroll]] do {
        through = bedThrough(s, color.rgb, depth, gatheredIn(color), i == 0 ? path : ray.onMap * wayPerDepth);
        mean += share * through.radiance;
        share = 1.0 - share;
        if (isSure) break;
        color = bedColorOf(shownBy(ray, bed.nearest));
        depth = ray.onMap - s.position.y + calmLevel();
    } while (++i < 2);
    through = Through(mean, path, blurred);
    if (!isSure) known = 1.0;
    return through;
}

// What shines through, along the ray that Snell's law bends: it is steeper than the line of sight, so the bed looks
// raised and little water lies before it. Sought is the depth under the surface at which the ray meets what the picture
// shows where the ray projects: a root, by false position between a place of the screen where the ray is before the scene
// and one where it is behind, which is exact for a plane. (A fixed point it is not: up a wall it would run away.) What
// stands out of the water is passed over. Where the ray leaves the picture, or passes behind something, the bed goes on by
// its slope. Where the line of sight itself passes over the bed's end, far off, it begins with what lies below at as much
// depth as can be seen through; over a shore with what its map says, which stands for a bed that falls away out of sight.
Through refractedBed(const SurfacePoint s, vec3 normal, vec3 toEye) {
    BentRay ray = bentRay(s, normal, toEye);
    Behind straight = bedAt(ray.here);
    ray.passedOver = straight.nothing;
    float nearer = nearerBy(ray.from, s.position, straight);
    bool nothing;
    BedFound bed = foundFirst(s, ray, straight, nothing);
    float known = 0.0;
    Through through = Through(vec3(0.0), endlessPath, 0.0);
    if (sceneSamples > 0 ? meetsScene(s, ray, bed) : !nothing) {
        if (refractionSamples > 1 && !bed.met) findRoot(s, ray, nearer, bed);
        through = throughBed(s, ray, bed, known);
    }
    through.radiance = mix(endlessWater(s).radiance, through.radiance, known);
    return through;
}

Through refracted(const SurfacePoint s, vec3 normal, vec3 toEye) {
    if (hasRefraction) return refractedBed(s, normal, toEye);
    return endlessWater(s);
}

#endif
