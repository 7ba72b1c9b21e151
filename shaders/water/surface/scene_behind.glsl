// What the host's opaque scene shows behind the surface.
#ifndef SCENE_BEHIND_GLSL
#define SCENE_BEHIND_GLSL

#include "surface.glsl"
#include "texel_at.glsl"
#include "encoding.glsl"

struct Behind {
    vec2 pixel;    // of the region
    vec3 seen;     // where, relative to the eye
    bool nothing;  // but the far plane
};

// By `q`, the homogeneous point that the depth says at the pixel's middle.
Behind shownAt(vec2 pixel, float depth, vec4 q) {
    const float leastWeight = 1e-12;   // what is infinitely far is taken to be very far, so that differences are numbers
    return Behind(pixel, q.xyz / max(q.w, leastWeight), isFarPlane(depth));
}

// What the host's opaque scene shows at a pixel of the region.
Behind behindAt(vec2 pixel) {
    ivec2 p = texelAt(pixel + water.sceneShift, regionSize() - 1);
    float depth = texelFetch(sceneDepth, sceneTexel(p), 0).r;
    return shownAt(vec2(p), depth, homogeneousPoint(floor(vec2(p)) + 0.5, depth));
}

vec4 linearTexel(vec4 held) {
    return vec4(linearOf(held.rgb, sceneIsEncoded), held.a);
}

// At a place of the region, whatever lies there.
vec3 sceneAround(vec2 pixel) {
    return linearOf(texelFetch(sceneColor, sceneTexel(ivec2(pixel + water.sceneShift)), 0).rgb, sceneIsEncoded);
}

vec4 colorOf(Behind b) {
    return linearTexel(texelFetch(sceneColor, sceneTexel(ivec2(b.pixel)), 0));
}

vec3 radianceOf(Behind b) {
    return colorOf(b).rgb;
}

// How far a ray from inside the picture goes until it leaves it [m]: where a + t b, homogeneous pixels, passes a border of
// a picture of that size.
float untilBorder(vec4 a, vec4 b, vec2 size) {
    // Gaps to the borders, times w, and how fast they shrink.
    vec4 gap = vec4(a.xy, size * a.w - a.xy);
    vec4 loss = vec4(-b.xy, b.xy - size * b.w);
    vec4 t = mix(vec4(1e6), gap / loss, greaterThan(loss, gap * 1e-6));
    return max(min(min(t.x, t.y), min(t.z, t.w)), 0.0);
}

#endif
