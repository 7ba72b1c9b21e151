// A host's own rough floor, by no shader of ours but what is installed for it: docs/integrating.md.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(binding = 0) uniform sampler2D reflectionColor;
layout(binding = 1) uniform sampler2D reflectionInfo;

#include "reflection_info.glsl"
#include "reflection_blur.glsl"
#include "reflection_source.glsl"
#include "reflection_texels.glsl"

layout(push_constant) uniform Floor {
    vec4 plane;            // of the points p with n.p + d = 0, relative to the eye
    vec4 blur;             // ReflectionDesc: clearDistance, scatter, skyFadeDistance; downscale
    float roughness;
    float pixelsPerRadian;
} ground;

layout(location = 0) in vec3 fromEye;
layout(location = 0) out vec4 outColor;

void main() {
    const float downscale = ground.blur.w;
    const float info = texelFetch(reflectionInfo, ivec2(gl_FragCoord.xy / downscale), 0).r;
    const float distance = infoIsHit(info) ? info : 1e5;
    const float cone = 3.545 * ground.roughness * ground.roughness;
    const float width = bundleWidth(cone, distance, ground.blur.xyz);
    const float texels = bundleTexels(width, length(fromEye), distance, ground.pixelsPerRadian / downscale);
    const vec4 mirrored = reflectionTexel(reflectionColor, reflectionInfo, gl_FragCoord.xy / downscale, bundleMip(texels), downscale);
    const Ray sight = Ray(vec3(0.0), normalize(fromEye));
    const vec3 source = mirroredPoint(sight, sight, distance, ground.plane.xyz, ground.plane.w);
    outColor = mirrored * (shareOfScene(distance, ground.blur.xyz) * smoothstep(1e5, 1e4, length(source)));
}
