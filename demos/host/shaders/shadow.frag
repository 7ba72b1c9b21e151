#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "frame.glsl"
#include "draw.glsl"
#include "bent_sun.glsl"

layout(constant_id = 0) const bool masked = false;
layout(constant_id = 1) const bool dithered = false;

layout(set = 1, binding = 0) uniform sampler2D baseColorMap;

layout(location = 0) in vec2 inUv;
layout(location = 1) in float inAlpha;
layout(location = 2) in vec3 inFromEye;

void main() {
    const int casts = int(draw.surface.w);
    // The texture's mip level comes from the whole quad, so it is read before any of its pixels is left.
    bool cutOut = false;
    if (masked || dithered) {
        const float least = dithered ? ditherThreshold(gl_FragCoord.xy, draw.emissive.w, dot(frame.toSun.xyz, inFromEye)) : draw.emissive.w;
        cutOut = draw.baseColor.a * inAlpha * texture(baseColorMap, inUv).a < least;
    }
    if (cutOut || casts != castsAll && isSunBent(inFromEye) != (casts == castsBent)) demote;
}
