// Places what was shaded of a surface in the host's pass, where nothing of the host's lies before it.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "body.glsl"
#include "view_pass_constants.h"
#include "encoding.glsl"
#include "found_surface.glsl"

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;
layout(set = 0, binding = shadedBinding) uniform sampler2D shadedColor;

layout(location = 0) out vec4 outColor;

void main() {
    ivec2 at = ivec2(regionPixel(gl_FragCoord.xy));
    float depth = texelFetch(foundDepth, at, 0).r;
    if (depth <= 0.0) demote;
    gl_FragDepth = hostDepth(depth);
    vec4 shown = texelFetch(shadedColor, at, 0);
    outColor = placesFigures ? shown : vec4(heldOf(shown.rgb, targetIsEncoded), 1.0);
}
