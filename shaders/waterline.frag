// The line that the water draws where it climbs the eye's lens.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface_uniforms.glsl"
#define TARGET_ENCODING 3
#include "encoding.glsl"
#include "optics.glsl"
#include "water_light.glsl"

#ifdef WAVES
layout(set = 0, binding = 1) uniform sampler2DArray waveDisplacement;
#endif
#ifdef SHORE
#define SHORE_BINDING 2
#include "shore.glsl"
#endif

layout(location = 0) out vec4 outColor;

#include "near_plane.glsl"
#ifdef WAVES
int cascades = stored.cascades;

#include "wave_displacement.glsl"
#endif
#include "waterline.glsl"

void main() {
    loadSurface();
    vec3 start = onNearPlane(gl_FragCoord.xy - vec2(region.xy));
    float height = heightAboveSurface(start);
#ifdef SHORE
    // Looked for at the next pixels anew: CPU devices read no buffer for those that derivatives alone ask.
    vec3 right = dFdx(start), down = dFdy(start);
    if (abs(height) > 4.0 * within.y) demote;
    vec2 change = vec2(heightAboveSurface(start + right), heightAboveSurface(start + down)) - height;
#else
    vec2 change = vec2(dFdx(height), dFdy(height));
#endif
    // Along the near plane, which may lie flat: pixels to the line, times metres a pixel.
    float perPixel = max(length(change), 1e-9);
    float distance = abs(height) / perPixel * length(dFdy(start));
    // A wedge of water bends what lies behind it out of sight: dark at its edge below, thinning upwards.
    float share = 1.0 - smoothstep(0.0, within.y, distance);
    if (share <= 0.0) demote;
    // What shows through dims as light does.
    float hides = 0.75 * share;
    if (targetIsEncoded) hides = 1.0 - heldGrowth(vec3(1.0 - hides)).x;
    outColor = vec4(heldOf(deepWater()), hides);
}
