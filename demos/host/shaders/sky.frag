#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(set = 0, binding = 1) uniform samplerCube skyCube;
layout(set = 0, binding = 2) uniform sampler2D skyImage;

#include "air.glsl"
#include "sky_detail.glsl"

layout(location = 0) in vec3 inDirection;
layout(location = 0) out vec4 outColor;

void main() {
    const vec3 d = normalize(inDirection);
    const float texel = 6.2831853 / float(textureSize(skyImage, 0).x), pixel = max(length(dFdx(d)), length(dFdy(d)));
    const vec3 from = frame.skyForward.w > 0.0 ? raggedSky(d, texel, pixel, frame.skyForward.w) : d;
    const float u = atan(from.z, from.x) / 6.2831853 - frame.sky.x;
    const float v = acos(clamp(from.y, -1.0, 1.0)) / 3.14159265;
    vec3 radiance = frame.sky.y * textureLod(skyImage, vec2(u, v), 0.0).rgb;
    const float sunRadius = 0.0047;
    const float soft = frame.sunRadiance.w;
    const float disc = 1.0 - smoothstep(sunRadius - soft, sunRadius + soft, length(d - frame.toSun.xyz));
    radiance += frame.sunRadiance.rgb * (frame.toSun.w * disc * smoothstep(-soft, soft, d.y));
    outColor = vec4(foggedSky(min(radiance, vec3(60000.0)), 0.0, d), 1.0);
}
