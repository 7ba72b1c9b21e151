// Finds the surface in a view: of each pixel the nearest that the host's scene does not hide.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface.glsl"

layout(location = 0) in vec2 meshCalm;
layout(location = 1) in vec3 meshPosition;
layout(location = 0) out uint outAside;

#include "globe.glsl"
#include "exclusion_volumes.glsl"
#include "surface_cut.glsl"
#include "found_surface.glsl"

bool isHidden() {
    if (!hasRefraction || manySamples) return false;   // other samples may show it
    return liesBefore(texelFetch(sceneDepth, sceneTexel(ivec2(gl_FragCoord.xy)), 0).r, gl_FragCoord.z);
}

void main() {
    vec3 position = vec3(meshPosition.x, meshPosition.y - globeDrop(meshCalm), meshPosition.z);
    if (!isSurface(meshCalm, position) || isHidden()) demote;
    outAside = heldAside(meshPosition.xz - meshCalm);
}
