// The water before the opaque scene, where the line of sight begins in it.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface_uniforms.glsl"
#define SCENE_ENCODING 2
#define TARGET_ENCODING 3
#include "encoding.glsl"
#include "optics.glsl"
#include "water_light.glsl"
#include "underwater_light.glsl"

layout(set = 0, binding = 1) uniform sampler2D sceneColor;
layout(set = 0, binding = 2) uniform sampler2D sceneDepth;
#ifdef WAVES
layout(set = 0, binding = 3) uniform sampler2DArray waveDisplacement;
#endif
#ifdef SHORE
#define SHORE_BINDING 4
#include "shore.glsl"
#endif

layout(constant_id = 0) const bool straddles = false;   // the view's near plane may be above the water too

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
    if (straddles && heightAboveSurface(start) > 0.0) demote;
    vec3 view = normalize(sightTo(start));
    float depth = depthOfSight(start);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float seen = texelFetch(sceneDepth, pixel, 0).r;
    // To the surface, which is drawn over it, or without an end.
    if (depthSign * (seen - farDepth) <= 0.0) {
        float path = view.y > 0.0 ? depth / view.y : 1e6;
        outColor = vec4(heldOf(scatteredIn(depth, view.y, min(path, 1e6))), 1.0);
        return;
    }
    vec4 q = relativeFromPixel * vec4(gl_FragCoord.xy - vec2(region.xy), seen, 1.0);
    vec3 at = q.xyz / q.w;
    float path = max(distanceTo(at) - distanceTo(start), 0.0);
    vec4 color = texelFetch(sceneColor, pixel, 0);
    vec3 lit = litBelow(linearOf(color.rgb), -(at.y + plane.w), gatheredIn(color));
    outColor = vec4(heldOf(throughWater(lit, depth, view.y, path)), 1.0);
}
