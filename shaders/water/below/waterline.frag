// The line that the water draws where it climbs the eye's lens.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#extension GL_EXT_control_flow_attributes : require
#include "body.glsl"
#include "encoding.glsl"
#include "optics.glsl"

#include "water_light.glsl"

layout(location = 0) out vec4 outColor;

#include "wave_maps.glsl"

#include "near_plane.glsl"
#include "wave_warp.glsl"
#include "shore.glsl"
#include "wave_displacement.glsl"
#include "waterline.glsl"

// How it changes to the next pixel, right and down.
vec2 changeOf(float height, vec3 start) {
    vec2 change = vec2(dFdx(height), dFdy(height));
    if (!hasShore) return change;
    // Looked for at the next pixels anew: CPU devices read no buffer for those that derivatives alone ask.
    vec3 right = dFdx(start), down = dFdy(start);
    if (abs(height) > 4.0 * water.halfMeniscus) demote;
    return vec2(heightAboveSurface(start + right), heightAboveSurface(start + down)) - height;
}

void main() {
    vec3 start = onNearPlane(regionPixel(gl_FragCoord.xy));
    float height = heightAboveSurface(start);
    vec2 change = changeOf(height, start);
    // Along the near plane, which may lie flat: pixels to the line, times metres a pixel.
    float perPixel = max(length(change), 1e-9);
    float distance = abs(height) / perPixel * length(dFdy(start));
    // A wedge of water bends what lies behind it out of sight: dark at its edge below, thinning upwards.
    float share = 1.0 - smoothstep(0.0, water.halfMeniscus, distance);
    if (share <= 0.0) demote;
    // What shows through dims as light does.
    float hides = 0.75 * share;
    if (targetIsEncoded) hides = 1.0 - heldGrowth(vec3(1.0 - hides)).x;
    outColor = vec4(heldOf(deepWater(sunAtEye()), targetIsEncoded), hides);
}
