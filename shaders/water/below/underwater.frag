// The water before the opaque scene, where the line of sight begins in it.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#extension GL_EXT_control_flow_attributes : require
#include "body.glsl"
#include "view_pass_constants.h"
#include "encoding.glsl"
#include "optics.glsl"

#include "water_light.glsl"
#include "lit_below.glsl"
#include "underwater_light.glsl"

layout(set = 0, binding = sceneColorBinding) uniform sampler2D sceneColor;
layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;

layout(location = 0) out vec4 outColor;

#include "wave_maps.glsl"

#include "near_plane.glsl"
#include "wave_warp.glsl"
#include "shore.glsl"
#include "wave_displacement.glsl"
#include "waterline.glsl"
#include "shafts.glsl"

void main() {
    vec2 place = regionPixel(gl_FragCoord.xy);
    vec3 start = onNearPlane(place);
    if (straddles && heightAboveSurface(start) > 0.0) demote;
    vec3 view = normalize(sightTo(start));
    float depth = depthOfSight(start);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float seen = texelFetch(sceneDepth, pixel, 0).r;
    bool endless = isFarPlane(seen);
    vec3 at = pointAt(place, seen);
    vec3 toSun = sunAtEye();
    float path = endless ? 1e6 : max(distanceTo(at) - distanceTo(start), 0.0);
    if (ofShafts) {
        vec3 added = shaftsIn(toSun, start, view, depth, pathInWater(view, depth, path));
        outColor = vec4(added, 0.0);
        if (targetIsEncoded) {   // over no less than what the water shows
            vec3 least = scatteredIn(toSun, depth, view.y, pathInWater(view, depth, path));
            outColor.rgb = heldOf(least + added, true) - heldOf(least, true);
        }
        return;
    }
    // To the surface, which is drawn over it, or without an end.
    if (endless) {
        path = pathInWater(view, depth, path);
        outColor = vec4(heldOf(scatteredIn(toSun, depth, view.y, path), targetIsEncoded), 1.0);
        return;
    }
    vec4 color = texelFetch(sceneColor, pixel, 0);
    vec3 lit = litBelow(toSun, linearOf(color.rgb, sceneIsEncoded), -heightOverCalm(at), gatheredIn(color));
    outColor = vec4(heldOf(throughWater(toSun, lit, depth, view.y, path), targetIsEncoded), 1.0);
}
