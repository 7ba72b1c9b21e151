// Planar reflection: what the host drew with the mirrored camera already lies on the pixels where the plane shows it.
// Depth tells how far behind the mirror; where nothing was drawn the plane mirrors the sky.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "firefly.glsl"
#include "mirror.glsl"
#include "planar_block.h"
#include "encoding.glsl"
#include "reflection_info.glsl"

#include "constant.glsl"
#include "scene_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = settingsBinding, std140) uniform MirroredView {
    PlanarBlock settings;
};
#ifdef MANY_DEPTHS
layout(set = 0, binding = mirroredDepthBinding) uniform sampler2DMS mirroredDepth;
#else
layout(set = 0, binding = mirroredDepthBinding) uniform sampler2D mirroredDepth;
#endif
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform writeonly image2D reflectionInfo;
#ifdef APART
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;
#ifdef MANY_COLORS
layout(set = 0, binding = mirroredColorBinding) uniform sampler2DMS mirroredColor;
#else
layout(set = 0, binding = mirroredColorBinding) uniform sampler2D mirroredColor;
#endif
#else
layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform image2D reflectionColor; // what the host has drawn
#endif

// Of what lies under the plane, drawn only where the oblique plane could not clip it: no more than this counts [m].
const float contact = 1e-3;

float drawnHeight(vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(settings.heightRow, p) / dot(settings.weightRow, p);
}

float infoOfDrawn(const MirrorBlock mirror, vec2 q, float depth) {
    float towardsPlane = sightThrough(mirror, q).towardsPlane;
    if (!(towardsPlane > 0.0)) return infoUnknown;
    if (isFar(mirror, depth)) return infoSky;
    float height = drawnHeight(vec3(q, depth));
    return height > -contact ? infoOfHit(height / towardsPlane) : infoUnknown;
}

float depthAt(ivec2 pixel, int i) {
    return texelFetch(mirroredDepth, pixel, i).r; // the mip, where there is one sample
}

vec3 colorAt(ivec2 pixel, int i) {
#ifdef APART
    return texelFetch(mirroredColor, pixel, i).rgb;
#else
    return imageLoad(reflectionColor, pixel).rgb;
#endif
}

struct Mirrored {
    float info;
    vec4 color; // times the share of the pixel that was drawn
};

#ifdef MANY_DEPTHS
// Where an edge crosses the pixel the sky shows beside it. What is farther than one hit, and nearer than another, lies nowhere:
// the first tells how far it is.
Mirrored mirroredBy(const MirrorBlock mirror, ivec2 pixel) {
    Mirrored m = Mirrored(infoUnknown, vec4(0.0));
    int count = int(settings.samples);
    for (int i = 0; i < count; ++i) {
        float info = infoOfDrawn(mirror, middleOf(mirror, pixel), depthAt(pixel, i));
        bool hit = infoIsHit(info);
        if (!infoIsHit(m.info) && (hit || i == 0)) m.info = info;
#ifdef MANY_COLORS
        if (hit) m.color.rgb += linearOf(colorAt(pixel, i), sceneIsEncoded);
#endif
        if (hit) m.color.a += 1.0;
    }
    m.color /= float(count);
#ifndef MANY_COLORS
    // Resolved over black, and so times that share already.
    if (m.color.a > 0.0) m.color.rgb = colorAt(pixel, 0);
    if (sceneIsEncoded && m.color.a > 0.0) m.color.rgb = linearOf(m.color.rgb / m.color.a, sceneIsEncoded) * m.color.a;
#endif
    return m;
}
#else
Mirrored mirroredBy(const MirrorBlock mirror, ivec2 pixel) {
    float info = infoOfDrawn(mirror, middleOf(mirror, pixel), depthAt(pixel, 0));
    return Mirrored(info, infoIsHit(info) ? vec4(linearOf(colorAt(pixel, 0), sceneIsEncoded), 1.0) : vec4(0.0));
}
#endif

// Of a group: where the host has drawn into the image that is written, others have been written over already.
shared vec4 mirrored[8][8];

vec3 withoutFirefly(Mirrored m) {
    ivec2 here = ivec2(gl_LocalInvocationID.xy);
    vec3 least = vec3(mostHeld), most = vec3(0.0);
    float others = 0.0;
    for (int i = 1; i < 4; ++i) {
        vec4 other = mirrored[here.y ^ (i >> 1)][here.x ^ (i & 1)];
        others += other.a;
        // The sky, which is not drawn, has no colour to compare with.
        vec3 color = other.rgb / max(other.a, 1e-6) * m.color.a;
        least = min(least, other.a > 0.0 ? color : vec3(mostHeld));
        most = max(most, color);
    }
    return others > 0.0 ? besides(m.color.rgb, least, most) : m.color.rgb;
}

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool within = all(lessThan(pixel, reflectionSize(mirror)));
    Mirrored m = Mirrored(infoUnknown, vec4(0.0));
    if (within) m = mirroredBy(mirror, pixel);
    mirrored[gl_LocalInvocationID.y][gl_LocalInvocationID.x] = m.color;
    barrier();
    if (!within) return;
    m.color.rgb = withoutFirefly(m);
    imageStore(reflectionColor, pixel, m.color);
    imageStore(reflectionInfo, pixel, vec4(m.info, 0.0, 0.0, 0.0));
}
