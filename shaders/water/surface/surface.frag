// Draws the water's surface: finds what its pixels show of it, and shades that.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#extension GL_EXT_control_flow_attributes : require
#include "surface.glsl"

layout(location = 0) in vec2 meshCalm;       // (u, v) before displacement, as the mesh has it
layout(location = 1) in vec3 meshPosition;   // likewise, and before it sinks on a globe
layout(location = 2) flat in uvec2 edgeRange;
layout(location = 0) out vec4 outColor;

#include "quad.glsl"
#include "surface_shading.glsl"
#include "surface_outputs.glsl"
#include "surface_cut.glsl"

// Metres of calm water to the next pixel.
float calmPixelWidth(vec2 right, vec2 down) {
    vec2 stepSize = max(abs(right), abs(down));
    return max(stepSize.x, stepSize.y);
}

// All of it but what light alone asks for: `sunSeen` and `air`.
SurfacePoint shownPoint(vec2 pixel, vec3 position, bool fromWater, bool quadIsAlike) {
    SurfacePoint s;
    s.pixel = pixel;
    s.fromWater = fromWater;
    s.quadIsAlike = quadIsAlike;
    vec2 right = dFdx(meshCalm), down = dFdy(meshCalm);
    s.footprint = footprintOf(right, down);
    s.pixelLength = calmPixelWidth(right, down);
    s.position = position;
    s.overPlane = meshPosition;
    s.height = meshPosition.y + water.plane.w;
    if (onGlobe) s.level = levelAt(meshCalm);
    if (hasShore) s.shore = shoreWave(meshCalm, s.pixelLength);
    s.calm = shownCalm(meshCalm, s.footprint, position, s.height, cross(dFdx(position), dFdy(position)));
    findSlopes(s);
    s.sunSeen = 1.0;
    s.air = vec4(vec3(0.0), 1.0);
    return s;
}

void main() {
    vec2 pixel = gl_FragCoord.xy - vec2(water.region.xy);
    vec3 position = vec3(meshPosition.x, meshPosition.y - globeDrop(meshCalm), meshPosition.z);
    bool fromWater = isFromWater(pixel);
    bool shows = isSurface(meshCalm, position);
    bool quadIsAlike = hasWaves && abs(meanOfQuad(vec4(shows ? (fromWater ? -1.0 : 1.0) : 0.0)).x) == 1.0;
    if (!shows) demote;   // `discard` would leave derivatives from here on undefined
    outColor = shaded(shownPoint(pixel, position, fromWater, quadIsAlike));
}
