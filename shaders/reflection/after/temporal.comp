// Temporal reuse: reflection/after/temporal.h. What a mirror shows lies behind it like a thing in the world, where the ray through
// a pixel is as long below the plane as the way to what it hits. That point is looked up in the frame before. An invocation
// takes a column of a tile, so that each row of what is found around its pixels is read once for three of them.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "encoding.glsl"
#include "temporal_block.h"
#include "reflection_info.glsl"
#include "tiles.glsl"

layout(set = 0, binding = settingsBinding, std140) uniform Temporal {
    TemporalBlock storedSettings;
};

layout(set = 0, binding = foundColorBinding) uniform sampler2D foundColor;
layout(set = 0, binding = foundInfoBinding) uniform sampler2D foundInfo;
layout(set = 0, binding = lastColorBinding) uniform sampler2D lastColor;
layout(set = 0, binding = lastInfoBinding) uniform sampler2D lastInfo;
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform writeonly image2D reflectionInfo;
#include "tile_columns.glsl"

const float leastWeight = 0.25;      // of what fits, among the texels between which a point falls
const float surely = 0.9;             // the same, to stand alone: what is known must not grow from frame to frame
const float leastConfidence = 1.0 / 32.0;
const float stillTexel = 1.0 / 128.0;
const float farAway = 1e5;
// How far two distances of one thing may be apart.
const float unlike = 0.1;
const float unlikeMetres = 0.05;

// Of both frames' images.
ivec2 lastPixel(const MirrorBlock mirror) {
    return reflectionSize(mirror) - 1;
}

bool isFinite(vec4 value) {
    return all(lessThanEqual(abs(value), vec4(mostOfHalf)));
}

struct Pixel {
    vec4 color;
    float info;
};

// What this frame found of some pixels.
struct Around {
    vec4 least;
    vec4 most;
    vec2 distances;   // of hits: the least and the greatest
    bool sky;
};

Around joined(Around a, Around b) {
    return Around(min(a.least, b.least), max(a.most, b.most),
                  vec2(min(a.distances.x, b.distances.x), max(a.distances.y, b.distances.y)), a.sky || b.sky);
}

// A pixel, and what was found of it and of those to its left and right.
struct Row {
    Pixel middle;
    Around around;
};

// `infos`: of the three, from left to right. Only hits have a colour, so that of the sky is known.
Row rowAt(const MirrorBlock mirror, ivec2 pixel, vec3 infos) {
    bvec3 hits = greaterThan(infos, vec3(0.0));
    bool sky = any(lessThan(infos, vec3(0.0)));
    vec3 least = mix(vec3(farAway), infos, hits);
    vec3 most = mix(vec3(0.0), infos, hits);
    vec2 distances = vec2(min(least.x, min(least.y, least.z)), max(most.x, max(most.y, most.z)));
    Row row = Row(Pixel(vec4(0.0), infos.y), Around(vec4(sky ? 0.0 : mostOfHalf), vec4(0.0), distances, sky));
    for (int i = 0; i < 3; ++i) {
        vec4 color = texelFetch(foundColor, clamp(pixel + ivec2(i - 1, 0), ivec2(0), lastPixel(mirror)), 0);
        if (i == 1) row.middle.color = color;
        bool counts = hits[i] && isFinite(color);
        row.around.least = min(row.around.least, counts ? color : vec4(mostOfHalf));
        row.around.most = max(row.around.most, counts ? color : vec4(0.0));
    }
    return row;
}

vec2 lastTexel(const MirrorBlock mirror, const TemporalBlock settings, vec3 image) {
    vec4 p = settings.lastFromRelative * vec4(image, 1.0);
    return p.w > 0.0 ? p.xy / (p.w * pixelEdge(mirror)) : vec2(-1.0);
}

SightLine lastSightLine(const MirrorBlock mirror, const TemporalBlock settings, vec2 texel) {
    return sightThrough(mirror, settings.relativeFromLast, texel * pixelEdge(mirror));
}

struct Remembered {
    vec4 color;
    float weight;     // of the texels that fit
    bool hit;
    float distance;   // of those that are hits
};

// Of three texels in a row for a place `at` from the middle of the second. What is looked up again and again must stay
// sharp: a parabola through all three.
float parabola(int texel, float at) {
    return texel == 0 ? 1.0 - at * at : 0.5 * at * (at + float(texel));
}

// Between those texels whose hits are as far as `distances`, or that are sky where that is asked for: linear, or by parabolas
// where all nine are such hits. A texel met in its middle is taken as it is: what stands still is not softened.
Remembered rememberedAt(ivec2 lastPixel, vec2 texel, vec2 distances, bool sky) {
    vec2 nearest = floor(texel);
    vec2 at = texel - nearest - 0.5;
    at = mix(at, vec2(0.0), lessThan(abs(at), vec2(stillTexel)));
    bool still = at == vec2(0.0);
    vec4 linear = vec4(0.0);
    vec4 sharp = vec4(0.0);
    float weight = 0.0;
    float hits = 0.0;
    float distance = 0.0;
    bool allHit = true;
    int i = still ? 4 : 0;
    int last = still ? 4 : 8;
    do {
        int row = i / 3 - 1;
        ivec2 off = ivec2(i - 3 * row - 4, row);
        vec2 place = nearest + vec2(off);
        bool inside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(lastPixel)));
        ivec2 from = texelAt(place, lastPixel);
        float info = texelFetch(lastInfo, from, 0).r;
        vec4 color = texelFetch(lastColor, from, 0);
        bool hit = infoIsHit(info);
        bool fits = inside && isFinite(color) && (hit ? info >= distances.x && info <= distances.y : sky && infoIsSky(info));
        allHit = allHit && hit && fits;
        color = fits ? color : vec4(0.0);
        vec2 apart = max(1.0 - abs(vec2(off) - at), 0.0);
        float share = fits ? apart.x * apart.y : 0.0;
        sharp += parabola(off.x, at.x) * parabola(off.y, at.y) * color;
        linear += share * color;
        weight += share;
        hits += hit ? share : 0.0;
        distance += hit ? share * info : 0.0;
    } while (++i <= last);
    return Remembered(allHit ? sharp : linear / max(weight, leastWeight), weight, hits > 0.5 * weight,
                      distance / max(hits, leastWeight));
}

vec2 likeDistances(vec2 distances) {
    return vec2(distances.x * (1.0 - unlike) - unlikeMetres, distances.y * (1.0 + unlike) + unlikeMetres);
}

// Where the last frame showed some point of a line of sight.
struct Place {
    vec2 texel;
    float distance;       // behind the mirror, of this frame's line of sight
    float distanceThen;   // and of the last one's
    bool found;
};

// Of the point `distance` behind the mirror; where that is `sought`, of one that the last frame knew of, found by fixed-point
// iteration from there on.
Place lastPlace(const MirrorBlock mirror, const TemporalBlock settings, SightLine sight, float distance, bool sought) {
    Place place = Place(vec2(0.0), distance, 0.0, true);
    int left = sought ? 3 : 0;
    do {
        vec3 image = sight.onPlane + sight.direction * place.distance;
        place.texel = lastTexel(mirror, settings, image);
        SightLine then = lastSightLine(mirror, settings, place.texel);
        place.distanceThen = dot(image - then.onPlane, then.direction);
        if (left == 0) break;
        ivec2 at = texelAt(place.texel, lastPixel(mirror));
        bool inside = all(greaterThanEqual(place.texel, vec2(0.0))) && all(lessThan(place.texel, vec2(lastPixel(mirror) + 1)));
        float info = inside ? texelFetch(lastInfo, at, 0).r : infoUnknown;
        place.found = infoIsHit(info);
        place.distance = max(dot(then.onPlane + then.direction * info - sight.onPlane, sight.direction), 0.0);
    } while (--left >= 0 && place.found);
    return place;
}

// Of what is as far behind the mirror as `distances`, the first of which is the place's.
Remembered rememberedOf(const MirrorBlock mirror, Place place, vec2 distances, bool sky) {
    // As much longer or shorter as the least; at contact the rounding of both is more than they are.
    vec2 expected = distances * ((max(place.distanceThen, 0.0) + unlikeMetres) / (distances.x + unlikeMetres));
    return rememberedAt(lastPixel(mirror), place.texel, likeDistances(expected), sky);
}

// Rounded to the digits of a half (Dekker 1971): on CPU devices packing and unpacking is dear.
vec4 asHalves(vec4 value) {
    precise vec4 scaled = 8193.0 * value;
    precise vec4 rest = value - scaled;
    precise vec4 rounded = scaled + rest;
    return rounded;
}

// Halves would keep a small difference for ever, of which a share is lost in rounding.
vec4 mixed(vec4 found, vec4 was, float share) {
    vec4 sum = asHalves(found + share * (was - found));
    return mix(sum, found, equal(sum, asHalves(was)));
}

Pixel blended(Pixel found, Around around, Remembered last, float share) {
    if (last.weight < leastWeight) return found;
    vec4 was = around.most.a > 0.0 ? clamp(last.color, around.least, around.most) : last.color;
    found.color = isFinite(found.color) ? mixed(found.color, was, share) : was;
    // At a silhouette that jitter moves over the pixel: whichever is more of it.
    if (last.hit != infoIsHit(found.info)) {
        bool hit = found.color.a >= 0.5 * around.most.a;
        if (hit != infoIsHit(found.info)) found.info = hit ? infoOfHit(around.distances.x) : infoSky;
    }
    return found;
}

// Where this frame knows nothing: what the last one knew of some point of the line of sight. That was sought by the distance
// of one texel; kept from frame to frame, it would lag behind the rest.
Pixel recalled(Pixel found, Around around, Remembered last, Place place, float kept) {
    vec4 color = kept * (around.most.a > 0.0 ? min(last.color, around.most) : last.color);
    if (last.weight < surely || color.a < leastConfidence) return found;
    return Pixel(color, infoOfHit(place.distance + last.distance - place.distanceThen));
}

Pixel settled(const MirrorBlock mirror, const TemporalBlock settings, ivec2 pixel, Pixel found, Around around) {
    bool known = found.info != infoUnknown;
    // Sky among sky is the same in all frames.
    if (settings.share == 0.0 || known && around.distances.y == 0.0) return found;
    vec2 q = middleOf(mirror, pixel) + settings.jitter;
    SightLine sight = sightThrough(mirror, q);
    if (!(sight.towardsPlane > 0.0)) return found;
    // The least distance tells, since the border of what is in front moves with that.
    Place place = lastPlace(mirror, settings, sight, around.distances.x, !known);
    if (!place.found) return found;
    vec2 distances = known ? around.distances : vec2(place.distance);
    Remembered last = rememberedOf(mirror, place, distances, known && around.sky);
    return known ? blended(found, around, last, settings.share) : recalled(found, around, last, place, settings.kept);
}

void main() {
    MirrorBlock mirror = storedMirror;
    TemporalBlock settings = storedSettings;
    vec2 perPixel = 1.0 / vec2(reflectionSize(mirror));
    Column column = columnToVisit(mirror);
    if (column.rows == 0) return;
    Row above, here;
    int y = -1;
    do {
        // Of two rows, the first above the corner.
        vec2 corner = vec2(column.top + ivec2(0, y + 1));
        vec4 left = textureGather(foundInfo, corner * perPixel);
        vec4 right = textureGather(foundInfo, (corner + vec2(1.0, 0.0)) * perPixel);
        ivec2 pixel = column.top + ivec2(0, y);
        Row below = rowAt(mirror, pixel, vec3(left.w, left.z, right.z));
        Row last = rowAt(mirror, pixel + ivec2(0, 1), vec3(left.x, left.y, right.y));
        int i = 0;
        do {
            int row = y - 1 + i;
            if (row >= 0 && row < column.rows) {
                Around around = joined(joined(above.around, here.around), below.around);
                ivec2 at = column.top + ivec2(0, row);
                Pixel result = settled(mirror, settings, at, here.middle, around);
                imageStore(reflectionColor, at, result.color);
                imageStore(reflectionInfo, at, vec4(result.info, 0.0, 0.0, 0.0));
            }
            above = here;
            here = below;
            below = last;
        } while (++i < 2);
        y += 2;
    } while (y <= column.rows);
}
