// The colour of the image sceneColor where a ray meets it.
#ifndef SOURCE_COLOR_GLSL
#define SOURCE_COLOR_GLSL

#include "constant.glsl"
#include "scene_constants.h"
#include "depth_quads.glsl"
#include "encoding.glsl"
#include "firefly.glsl"

layout(set = 0, binding = sceneColorBinding) uniform sampler2D sceneColor;

// Of a picture one pixel wide none lies before the first.
vec3 texelColor(const MirrorBlock mirror, ivec2 pixel) {
    return linearOf(texelFetch(sceneColor, sceneTexel(mirror, max(pixel, 0)), 0).rgb, sceneIsEncoded);
}

// Between the four texels around, where these show one plane on which the ray is there: depth is affine on the screen over
// a plane. Else the one texel that the point falls in, since what does not belong together is not blended. `nearness` is
// the ray's depth from infinityDepth.
vec3 sourceColor(const MirrorBlock mirror, vec2 source, float nearness) {
    ivec2 corner = max(regionPixel(mirror, source + 0.5), 1);
    vec2 beyond = clamp(source + 0.5 - vec2(corner), 0.0, 1.0);
    vec4 depths = depthsAround(mirror, corner, perDepthTexel());
    vec4 seen = allFromInfinity(mirror, depths);
    vec2 rows = mix(seen.wx, seen.zy, beyond.x);
    float off = abs(mix(rows.x, rows.y, beyond.y) - nearness);
    float twist = abs(seen.x + seen.z - seen.y - seen.w);
    float least = min(min(seen.x, seen.y), min(seen.z, seen.w));
    float most = max(max(seen.x, seen.y), max(seen.z, seen.w));
    float rounding = 4e-6 * abs(depthFromInfinity(mirror, nearness)) + 2.0 * mirror.depthStep;
    Four colors = withoutFireflies(Four(texelColor(mirror, corner - 1), texelColor(mirror, corner - ivec2(0, 1)),
                                        texelColor(mirror, corner - ivec2(1, 0)), texelColor(mirror, corner)));
    vec4 nears = signedDepths(mirror, depths);
    float farthest = min(min(nears.x, nears.y), min(nears.z, nears.w));
    // Under the plane's horizon the far plane shows what no ray can meet.
    float depth = signedDepth(mirror, farthest);
    bool mixesIn = isFar(mirror, depth) && wellBelowPlane(mirror, vec3(vec2(corner), depth));
    bool apart = max(off, twist) > 0.05 * (most - least) + rounding || mixesIn;
    vec2 share = apart ? step(0.5, beyond) : beyond;
    return mix(mix(colors.upperLeft, colors.upperRight, share.x), mix(colors.lowerLeft, colors.lowerRight, share.x), share.y);
}

#endif
