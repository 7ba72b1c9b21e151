#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "frame.glsl"
#include "draw.glsl"
#include "sunlight.glsl"

layout(constant_id = 0) const bool masked = false;

layout(set = 0, binding = 1) uniform samplerCube skyCube;
layout(set = 1, binding = 0) uniform sampler2D baseColorMap;
layout(set = 1, binding = 1) uniform sampler2D metallicRoughnessMap;

layout(location = 0) in vec3 inFromEye;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;

layout(location = 0) out vec4 outColor;

// Specular reflectance of a rough surface in uniform light (Karis 2014, "Physically Based Shading on Mobile").
vec3 environmentBrdf(vec3 f0, float roughness, float nDotV) {
    const vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    const float a = min(r.x * r.x, exp2(-9.28 * nDotV)) * r.x + r.y;
    const vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
    return f0 * ab.x + ab.y;
}

// The triangle's own normal, on the side of `smoothed`'s; that one where a triangle has no area.
vec3 facetNormal(vec3 across, vec3 smoothed) {
    const float area = length(across);
    return area > 0.0 ? across / (dot(across, smoothed) < 0.0 ? -area : area) : smoothed;
}

void main() {
    const vec3 across = cross(dFdx(inFromEye), dFdy(inFromEye));   // before any pixel of the quad is left
    const vec4 base = draw.baseColor * inColor * texture(baseColorMap, inUv);
    if (masked && base.a < draw.emissive.w) demote;   // the next look wants the whole quad
    const vec4 mr = texture(metallicRoughnessMap, inUv);
    // What metal mirrors in water is the water and the bed around it, no sky: as bright as what is matte and of its colour.
    const bool inWater = isSunBent(inFromEye);
    const float metallic = inWater ? 0.0 : draw.surface.x * mr.b;
    const float roughness = clamp(draw.surface.y * mr.g, 0.06, 1.0);
    const vec3 f0 = mix(vec3(0.04), base.rgb, metallic);
    const vec3 diffuse = base.rgb * (1.0 - metallic);

    vec3 n = normalize(inNormal);
    if (!gl_FrontFacing) n = -n;
    const vec3 v = -normalize(inFromEye * frame.sight.w + frame.sight.xyz);
    const vec3 l = frame.toSun.xyz;
    const float nDotL = facingSun(inFromEye, n), nDotV = max(abs(dot(n, v)), 1e-3);

    // Of index 1.5, which mirrors a tenth as much in water as in air.
    const float mirrors = inWater ? 0.087 : 1.0;

    vec3 radiance = draw.emissive.rgb;
    if (nDotL > 0.0) {
        const vec3 sun = frame.sunIrradiance.rgb * (nDotL * sunVisibility(inFromEye, facetNormal(across, n), n));
        radiance += sun * (diffuse / pi + mirrors * sunSpecular(n, v, l, nDotL, nDotV, f0, roughness));
    }
    const vec3 ambient = mirrors * environmentBrdf(f0, roughness, nDotV);
    // The mip whose texels are as large as the lobe: solid angles 4 pi alpha^2 and 4 pi / (6 size^2).
    const float mip = log2(frame.sky.w * roughness * roughness * 2.449);
    const vec3 mirror = reflect(-v, n);
    const vec3 mirrored = inWater ? facingSky(inFromEye, mirror) / pi : textureLod(skyCube, mirror, clamp(mip, 0.0, frame.sky.z - 1.0)).rgb;
    radiance += diffuse / pi * facingSky(inFromEye, n) * (1.0 - ambient) + mirrored * ambient;
    outColor = vec4(min(radiance, vec3(60000.0)), 1.0);
}
