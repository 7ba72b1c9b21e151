// Temporal reuse: reflection/temporal.h. What a mirror shows lies behind it like a thing in the world, where the ray through
// a pixel is as long below the plane as the way to what it hits. That point is looked up in the frame before.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "sight_line.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Loaded once, as mirror.glsl's are.
mat4 lastFromRelative;   // to the last frame's pixels, from where this frame's eye is
mat4 relativeFromLast;   // and back
vec2 jitter;             // this frame's [pixel]
float share;             // of the last frame, 0 where there is none
float kept;              // of the confidence, where only the last frame knows

layout(set = 0, binding = 1, std140) uniform Temporal {
    mat4 lastFromRelative;
    mat4 relativeFromLast;
    vec2 jitter;
    float share;
    float kept;
} storedTemporal;

void loadTemporal() {
    lastFromRelative = storedTemporal.lastFromRelative;
    relativeFromLast = storedTemporal.relativeFromLast;
    jitter = storedTemporal.jitter;
    share = storedTemporal.share;
    kept = storedTemporal.kept;
}
layout(set = 0, binding = 2) uniform sampler2D foundColor;
layout(set = 0, binding = 3) uniform sampler2D foundInfo;
layout(set = 0, binding = 4) uniform sampler2D lastColor;
layout(set = 0, binding = 5) uniform sampler2D lastInfo;
layout(set = 0, binding = 6, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = 7, r16f) uniform writeonly image2D reflectionInfo;

const float leastWeight = 0.25;      // of what fits, among the texels between which a point falls
const float surely = 0.9;             // the same, to stand alone: what is known must not grow from frame to frame
const float leastConfidence = 1.0 / 32.0;
const float stillTexel = 1.0 / 128.0;
const float farAway = 1e5;
// How far two distances of one thing may be apart.
const float unlike = 0.1;
const float unlikeMetres = 0.05;

bool isFinite(vec4 value) {
    return !any(isnan(value)) && !any(isinf(value));
}

// What this frame found of a pixel and of the eight around it.
struct Around {
    vec4 least;
    vec4 most;
    vec2 distances;   // of hits: the least and the greatest
    bool sky;
};

Around foundAround(ivec2 pixel) {
    ivec2 last = imageSize() - 1;
    Around around = Around(vec4(65504.0), vec4(0.0), vec2(farAway, 0.0), false);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
            float info = texelFetch(foundInfo, at, 0).r;
            vec4 color = texelFetch(foundColor, at, 0);
            around.sky = around.sky || infoIsSky(info);
            if (infoIsHit(info)) around.distances = vec2(min(around.distances.x, info), max(around.distances.y, info));
            if (info == infoUnknown || !isFinite(color)) continue;
            around.least = min(around.least, color);
            around.most = max(around.most, color);
        }
    return around;
}

vec2 lastTexel(vec3 image) {
    vec4 p = lastFromRelative * vec4(image, 1.0);
    return p.w > 0.0 ? p.xy / (p.w * float(1 << pixelShift)) : vec2(-1.0);
}

SightLine lastSightLine(vec2 texel) {
    return sightLine(relativeFromLast, texel * float(1 << pixelShift));
}

struct Remembered {
    vec4 color;
    float weight;   // of the texels that fit
    bool hit;
};

// Of four texels in a row for a place `at` between the middle two. What is looked up again and again must stay sharp
// (Catmull and Rom 1974).
vec4 cubicWeights(float at) {
    vec2 outer = at * vec2(-0.5 + at * (1.0 - 0.5 * at), at * (0.5 * at - 0.5));
    float nearer = 1.0 + at * at * (1.5 * at - 2.5);
    return vec4(outer.x, nearer, 1.0 - nearer - outer.x - outer.y, outer.y);
}

// Between those texels whose hits are as far as `distances`, or that are sky where that is asked for: cubic where all fit,
// else linear. A texel met in its middle is taken as it is: what stands still is not softened.
Remembered rememberedAt(vec2 texel, vec2 distances, bool sky) {
    vec2 corner = floor(texel - 0.5);
    vec2 between = texel - 0.5 - corner;
    corner += vec2(greaterThan(between, vec2(1.0 - stillTexel)));
    between = mix(between, vec2(0.0), lessThan(min(between, 1.0 - between), vec2(stillTexel)));
    bool still = between == vec2(0.0);
    vec4 cubicX = cubicWeights(between.x);
    vec4 cubicY = cubicWeights(between.y);
    vec4 linear = vec4(0.0);
    vec4 cubic = vec4(0.0);
    float weight = 0.0;
    float hits = 0.0;
    bool all16 = true;
    for (int i = still ? 5 : 0; i < (still ? 6 : 16); ++i) {
        ivec2 off = ivec2(i & 3, i >> 2);
        ivec2 at = ivec2(corner) + off - 1;
        bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, imageSize()));
        at = inside ? at : ivec2(0);
        float info = texelFetch(lastInfo, at, 0).r;
        vec4 color = texelFetch(lastColor, at, 0);
        bool isHit = infoIsHit(info);
        bool fits = isHit ? info >= distances.x && info <= distances.y : sky && infoIsSky(info);
        fits = fits && inside && isFinite(color);
        all16 = all16 && fits;
        if (!fits) continue;
        vec2 apart = max(1.0 - abs(vec2(off - 1) - between), 0.0);
        float share = apart.x * apart.y;
        linear += share * color;
        cubic += cubicX[off.x] * cubicY[off.y] * color;
        weight += share;
        hits += isHit ? share : 0.0;
    }
    return Remembered(all16 ? cubic : linear / max(weight, leastWeight), weight, hits > 0.5 * weight);
}

vec2 likeDistances(vec2 distances) {
    return vec2(distances.x * (1.0 - unlike) - unlikeMetres, distances.y * (1.0 + unlike) + unlikeMetres);
}

// Of what lies `distances` behind the mirror along a line of sight, first the least: the border of what is in front moves
// with that.
Remembered rememberedOf(SightLine sight, vec2 distances, bool sky) {
    vec3 image = sight.onPlane + sight.direction * distances.x;
    vec2 texel = lastTexel(image);
    SightLine then = lastSightLine(texel);
    float distanceThen = dot(image - then.onPlane, then.direction);
    // As much longer or shorter as the least; at contact the rounding of both is more than they are.
    vec2 expected = distances * ((max(distanceThen, 0.0) + unlikeMetres) / (distances.x + unlikeMetres));
    return rememberedAt(texel, likeDistances(expected), sky);
}

struct Pixel {
    vec4 color;
    float info;
};

vec4 asHalves(vec4 value) {
    return vec4(unpackHalf2x16(packHalf2x16(value.xy)), unpackHalf2x16(packHalf2x16(value.zw)));
}

// Halves would keep a small difference for ever, of which a share is lost in rounding.
vec4 mixed(vec4 found, vec4 was) {
    vec4 sum = asHalves(found + share * (was - found));
    return mix(sum, found, equal(sum, asHalves(was)));
}

Pixel blended(Pixel found, Around around, SightLine sight) {
    Remembered last = rememberedOf(sight, around.distances, around.sky);
    if (last.weight < leastWeight) return found;
    vec4 was = around.most.a > 0.0 ? clamp(last.color, around.least, around.most) : last.color;
    found.color = isFinite(found.color) ? mixed(found.color, was) : was;
    // At a silhouette that jitter moves over the pixel: whichever is more of it.
    if (last.hit != infoIsHit(found.info)) {
        bool hit = found.color.a >= 0.5 * around.most.a;
        if (hit != infoIsHit(found.info)) found.info = hit ? infoOfHit(around.distances.x) : infoSky;
    }
    return found;
}

// Where this frame knows nothing: what the last one knew of some point of the line of sight, found by fixed-point iteration
// on its distance.
Pixel recalled(Pixel found, Around around, SightLine sight) {
    float distance = around.distances.x;
    for (int i = 0; i < 3; ++i) {
        vec2 texel = lastTexel(sight.onPlane + sight.direction * distance);
        ivec2 at = ivec2(floor(texel));
        bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, imageSize()));
        float info = inside ? texelFetch(lastInfo, at, 0).r : infoUnknown;
        SightLine then = lastSightLine(texel);
        vec3 image = then.onPlane + then.direction * info;
        if (infoIsHit(info)) distance = max(dot(image - sight.onPlane, sight.direction), 0.0);
    }
    Remembered last = rememberedOf(sight, vec2(distance), false);
    vec4 color = kept * (around.most.a > 0.0 ? min(last.color, around.most) : last.color);
    if (last.weight < surely || color.a < leastConfidence) return found;
    return Pixel(color, infoOfHit(distance));
}

void main() {
    loadMirror();
    loadTemporal();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize()))) return;
    Pixel result = Pixel(texelFetch(foundColor, pixel, 0), texelFetch(foundInfo, pixel, 0).r);
    SightLine sight = sightLine(relativeFromPixel, middleOf(pixel) + jitter);
    // Loops of one round, since CPU devices leave those out that nobody enters.
    for (bool looks = share > 0.0 && sight.towardsPlane > 0.0; looks; looks = false) {
        Around around = foundAround(pixel);
        bool known = result.info != infoUnknown;
        for (bool blends = known && around.distances.y > 0.0; blends; blends = false) result = blended(result, around, sight);
        for (bool recalls = !known; recalls; recalls = false) result = recalled(result, around, sight);
    }
    imageStore(reflectionColor, pixel, result.color);
    imageStore(reflectionInfo, pixel, vec4(result.info, 0.0, 0.0, 0.0));
}
