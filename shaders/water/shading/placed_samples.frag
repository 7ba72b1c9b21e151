// Places what was shaded of a surface in a multisampled pass, by the mesh: samples that water covers beside the middle of a pixel
// that shows none take a neighbour's.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface.glsl"

layout(location = 0) in vec2 meshCalm;
layout(location = 1) in vec3 meshPosition;
layout(location = 0) out vec4 outColor;

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;
layout(set = 0, binding = shadedBinding) uniform sampler2D shadedColor;

#include "encoding.glsl"
#include "globe.glsl"
#include "exclusion_volumes.glsl"
#include "surface_cut.glsl"
#include "found_surface.glsl"

// The pixel itself, or one beside it; false where none shows water.
bool findNear(inout ivec2 at) {
    const ivec2 beside[9] = ivec2[](ivec2(0, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 0), ivec2(-1, 0),
                                    ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));
    ivec2 here = at;
    bool isFound;
    int i = 0;
    do {
        at = clamp(here + beside[i], ivec2(0), regionSize() - 1);
        isFound = texelFetch(foundDepth, at, 0).r > 0.0;
    } while (++i < 9 && !isFound);
    return isFound;
}

void main() {
    vec3 position = vec3(meshPosition.x, meshPosition.y - globeDrop(meshCalm), meshPosition.z);
    if (!isSurface(meshCalm, position)) demote;
    ivec2 at = ivec2(regionPixel(gl_FragCoord.xy));
    if (!findNear(at)) demote;
    vec4 shown = texelFetch(shadedColor, at, 0);
    outColor = writesLight ? vec4(heldOf(shown.rgb, targetIsEncoded), 1.0) : shown;
}
