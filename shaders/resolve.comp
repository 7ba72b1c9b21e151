// SSPR, second pass: turns mirrored depths into colour. A candidate depth is followed back to its source, the surface
// that is really seen there is mirrored again, and the candidate counts only when that lands on this pixel: holes are
// filled and leaks refused by proof instead of by likeness of colour.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "edge_fade.glsl"
#include "reflection_info.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) readonly buffer Keys {
    uint keys[];
};
layout(set = 0, binding = 3) uniform sampler2D sceneColor;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = 5, r16f) uniform writeonly image2D reflectionInfo;

const float acceptedPixels = 0.75;
const int refinements = 3;

struct Hit {
    bool valid;
    vec2 source;      // pixel
    float depth;      // mirrored, at this pixel
};

float depthAt(vec2 pixel) {
    return texelFetch(sceneDepth, region.xy + ivec2(pixel), 0).r;
}

Hit refined(vec2 q, float mirroredDepth) {
    Hit hit = Hit(false, vec2(0.0), mirroredDepth);
    for (int i = 0; i < refinements; ++i) {
        vec4 source = mirrored(vec3(q, hit.depth));
        if (!(source.w > 0.0) || !insideRegion(source.xy)) return Hit(false, vec2(0.0), 0.0);
        float seen = depthAt(source.xy);
        vec3 surface = vec3(source.xy, seen);
        if (isFar(seen) || heightAbovePlane(surface) < -contactHeight(surface)) return Hit(false, vec2(0.0), 0.0);
        vec4 back = mirrored(surface);
        if (!(back.w > 0.0)) return Hit(false, vec2(0.0), 0.0);
        hit.source = source.xy;
        hit.depth = back.z;
        vec2 miss = back.xy - q;
        hit.valid = dot(miss, miss) <= acceptedPixels * acceptedPixels;
    }
    return hit;
}

uint keyAt(ivec2 pixel) {
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, region.zw))) return noKey;
    return keys[pixel.y * region.z + pixel.x];
}

// The nearest key around `pixel` that is farther than `last`, whose turn is over.
uint nextKey(ivec2 pixel, uint last) {
    uint best = noKey;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            uint key = keyAt(pixel + ivec2(x, y));
            if (key < last) best = max(best, key);
        }
    return best;
}

// The pixel's own key first, then its neighbours' from near to far; the first that proves itself counts. One flat loop:
// CPU devices mask branches instead of jumping them, but do leave a loop when nobody is in it.
Hit nearestHit(ivec2 pixel, vec2 q) {
    Hit hit = Hit(false, vec2(0.0), 0.0);
    uint key = keyAt(pixel);
    uint last = ~0u;
    if (key == noKey) key = last = nextKey(pixel, last);
    while (key != noKey) {
        hit = refined(q, depthFromKey(key));
        if (hit.valid) break;
        key = last = nextKey(pixel, last);
    }
    return hit;
}

// The mirrored ray's far end tells whether the sky it would reach is on the screen.
float infoOfMiss(vec2 q) {
    vec4 end = mirrored(vec3(q, infinityDepth));
    if (!(end.w > 0.0) || !insideRegion(end.xy)) return infoUnknown;
    return isFar(depthAt(end.xy)) ? infoSky : infoUnknown;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, region.zw))) return;
    vec2 q = vec2(pixel) + 0.5;

    // Any depth serves to find the ray through this pixel; half way avoids both ends.
    vec3 ray = normalize(unprojected(vec3(q, 0.5)));
    float towardsPlane = -dot(plane.xyz, ray);
    vec4 color = vec4(0.0);
    float info = infoUnknown;
    if (towardsPlane > 0.0) {
        Hit hit = nearestHit(pixel, q);
        if (hit.valid) {
            float confidence = edgeConfidence(q, hit.source);
            color = vec4(texelFetch(sceneColor, region.xy + ivec2(hit.source), 0).rgb * confidence, confidence);
            float beyond = length(unprojected(vec3(q, hit.depth))) - plane.w / towardsPlane;
            info = infoOfHit(beyond);
        } else {
            info = infoOfMiss(q);
        }
    }
    imageStore(reflectionColor, pixel, color);
    imageStore(reflectionInfo, pixel, vec4(info, 0.0, 0.0, 0.0));
}
