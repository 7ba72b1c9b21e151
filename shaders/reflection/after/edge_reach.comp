// Edge reach: reflection/after/edge_reach.h. On the screen a mirrored ray is a line along which its nearness is linear, and so is
// that of a plane that shows there: beyond the border, too, they meet in closed form.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "firefly.glsl"
#include "mirror.glsl"
#include "edge_reach_block.h"
#include "encoding.glsl"
#include "edge_fade.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"

#include "constant.glsl"
#include "scene_constants.h"

layout(set = 0, binding = settingsBinding, std140) uniform EdgeReach {
    EdgeReachBlock settings;
};
layout(set = 0, binding = sceneColorBinding) uniform sampler2D sceneColor;
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform image2D reflectionInfo;

#include "scene_depth.glsl"
#include "miss.glsl"
#include "screen_ray.glsl"
#include "hit_distance.glsl"
#include "tile_columns.glsl"

const float leastInside = 8.0;    // pixels inside of the border over which a plane is told
const float insideShare = 2.0;    // of what it is taken to go on beyond
const float uneven = 0.02;        // share of its nearness by which a plane may be off, as walls with windows are
const float leastColor = 0.02;    // confidence by which colour is scaled without loss of digits
const float sameDistance = 0.05;  // share by which hits on one plane may differ

// Where a line leaves the picture.
struct Exit {
    vec2 border;    // its last point
    vec2 outward;   // a pixel's step
};

Exit exitOf(const MirrorBlock mirror, vec2 q, vec2 along) {
    vec2 outward = along / max(max(abs(along.x), abs(along.y)), 1e-30);
    return Exit(q + outward * (stepsToBorder(mirror, q, outward) - 0.5), outward);
}

vec2 insideOf(const MirrorBlock mirror, Exit at, float pixels) {
    return clamp(at.border - pixels * at.outward, vec2(0.5), vec2(regionSize(mirror)) - 0.5);
}

// From infinity; none of the sky and of what lies below the plane.
float nearnessAt(const MirrorBlock mirror, vec2 point) {
    ivec2 pixel = regionPixel(mirror, point);
    float depth = depthAt(mirror, pixel);
    return solid(mirror, pixel, depth) ? signedDepth(mirror, fromInfinity(mirror, depth)) : 0.0;
}

// What a line's nearness is at the border, and how much more a pixel beyond.
struct Nearness {
    bool known;
    float atBorder;
    float perPixel;
};

float nearnessBeyond(Nearness line, float pixels) {
    return line.atBorder + pixels * line.perPixel;
}

Nearness nearnessOf(const MirrorBlock mirror, ScreenRay ray, Exit at) {
    float atBorder = signedDepth(mirror, rayDepthAt(ray, at.border));
    float inside = signedDepth(mirror, rayDepthAt(ray, at.border - leastInside * at.outward));
    return Nearness(atBorder > 0.0, atBorder, (atBorder - inside) / leastInside);
}

// Of what shows, if it is one plane for so many pixels inside of the border.
Nearness nearnessOfPlane(const MirrorBlock mirror, Exit at, float pixels) {
    float atBorder = nearnessAt(mirror, insideOf(mirror, at, 0.0));
    float middle = nearnessAt(mirror, insideOf(mirror, at, 0.5 * pixels));
    float last = nearnessAt(mirror, insideOf(mirror, at, pixels));
    bool even = abs(middle - 0.5 * (atBorder + last)) <= uneven * atBorder;
    return Nearness(even && min(min(atBorder, middle), last) > 0.0, atBorder, (atBorder - last) / pixels);
}

struct Meeting {
    bool found;
    float beyond;   // the border [pixel]; inside of it where negative
};

// The ray must go in behind the plane, and neither be at infinity by then.
Meeting meetingOf(Nearness ray, Nearness seen) {
    float closing = seen.perPixel - ray.perPixel;
    float beyond = (ray.atBorder - seen.atBorder) / closing;
    bool found = seen.known && closing > 0.0 && abs(beyond) <= settings.reach && nearnessBeyond(seen, beyond) > 0.0;
    return Meeting(found, beyond);
}

Meeting meetingBeyond(const MirrorBlock mirror, Exit at, Nearness ray) {
    Meeting guess = meetingOf(ray, nearnessOfPlane(mirror, at, leastInside));
    if (!guess.found) return guess;
    return meetingOf(ray, nearnessOfPlane(mirror, at, max(insideShare * abs(guess.beyond), leastInside)));
}

// What the border may have cut off.
bool isCut(ivec2 texel) {
    float info = imageLoad(reflectionInfo, texel).r;
    return !infoIsSky(info) && imageLoad(reflectionColor, texel).a < 1.0;
}

vec3 colorAt(const MirrorBlock mirror, ivec2 pixel) {
    return linearOf(texelFetch(sceneColor, sceneTexel(mirror, min(pixel, regionSize(mirror) - 1)), 0).rgb, sceneIsEncoded);
}

void reachBeyond(const MirrorBlock mirror, ivec2 texel) {
    vec2 q = middleOf(mirror, texel);
    ScreenRay ray = rayOf(mirror, q);
    Exit at = exitOf(mirror, q, -depthSign(mirror) * (ray.along.xy - q * ray.along.w));
    Nearness nearness = nearnessOf(mirror, ray, at);
    Meeting meeting = meetingBeyond(mirror, at, nearness);
    if (!planeAhead(mirror, q) || !nearness.known || !meeting.found) return;
    float info = imageLoad(reflectionInfo, texel).r;
    vec4 known = imageLoad(reflectionColor, texel);
    float confidence = confidenceWithin(mirror, settings.reach - meeting.beyond);
    float distance = infoOfHit(distanceToHit(mirror, q, depthOn(ray, at.border + meeting.beyond * at.outward)));
    // Hits that faded at the border are seen to go on.
    bool goesOn = infoIsHit(info) && abs(info - distance) <= sameDistance * distance && confidence > known.a;
    if (!goesOn && (infoIsHit(info) || meeting.beyond < 0.0)) return;
    // Beyond the border a plane looks as it does as far inside.
    ivec2 inside = regionPixel(mirror, insideOf(mirror, at, abs(meeting.beyond)));
    vec3 other = colorAt(mirror, inside ^ ivec2(1, 0));
    vec3 light = besides(colorAt(mirror, inside), other, other);
    bool hasColor = goesOn && known.a > leastColor;
    imageStore(reflectionColor, texel, (hasColor ? known / known.a : vec4(light, 1.0)) * confidence);
    imageStore(reflectionInfo, texel, vec4(goesOn ? info : distance, 0.0, 0.0, 0.0));
}

void main() {
    MirrorBlock mirror = storedMirror;
    Column column = columnToVisit(mirror);
    if (column.rows == 0) return;
    int row = 0;
    do {
        // Over what is whole at once: what stands under a condition runs for all. Nothing but the count leaves the inner loop:
        // llvmpipe spoils other values for columns that have left it.
        while (row < column.rows && !isCut(column.top + ivec2(0, row))) ++row;
        if (row < column.rows) reachBeyond(mirror, column.top + ivec2(0, row));
    } while (++row < column.rows);
}
