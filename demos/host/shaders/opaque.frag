#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "frame.glsl"
#include "draw.glsl"
#include "sunlight.glsl"

// MaterialFeature of mesh_file.h.
layout(constant_id = 0) const bool masked = false;
layout(constant_id = 1) const bool dithered = false;
layout(constant_id = 2) const bool unlit = false;
layout(constant_id = 3) const bool specularGlossiness = false;
layout(constant_id = 4) const bool hasEmissiveMap = false;
layout(constant_id = 5) const bool hasNormalMap = false;
layout(constant_id = 6) const bool hasOcclusionMap = false;
layout(constant_id = 7) const bool otherUvs = false;

layout(set = 0, binding = 1) uniform samplerCube skyCube;
layout(set = 1, binding = 0) uniform sampler2D baseColorMap;
layout(set = 1, binding = 1) uniform sampler2D surfaceMap;   // metalness and roughness, or specular colour and glossiness
layout(set = 1, binding = 2) uniform sampler2D emissiveMap;
layout(set = 1, binding = 3) uniform sampler2D normalMap;
layout(set = 1, binding = 4) uniform sampler2D occlusionMap;

#include "air.glsl"
#include "wet_sand.glsl"

layout(location = 0) in vec3 inFromEye;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec2 inOtherUv[4];

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

// Where the map at binding `slot` lies, of those behind the first.
vec2 uvOf(int slot) {
    return otherUvs ? inOtherUv[slot - 1] : inUv;
}

// The normal map's in the frame that the texture's own axes give at the pixel, without tangents (Schueler 2013, "Followup:
// Normal Mapping Without Precomputed Tangents"). Its green points up the image, against v.
vec3 mappedNormal(vec3 n, vec3 across) {
    const vec2 uv = uvOf(3);
    const vec3 rightM = dFdx(inFromEye), belowM = dFdy(inFromEye);
    const vec2 right = dFdx(uv), below = dFdy(uv);
    const vec3 fromRight = cross(belowM, n), fromBelow = cross(n, rightM);
    const float side = dot(across, n) < 0.0 ? -1.0 : 1.0;
    const vec3 alongU = side * (fromRight * right.x + fromBelow * below.x);
    const vec3 alongV = side * (fromRight * right.y + fromBelow * below.y);
    const float longest = max(dot(alongU, alongU), dot(alongV, alongV));
    const vec3 lean = 2.0 * texture(normalMap, uv).xyz - 1.0;
    if (longest <= 0.0) return n;
    const float scale = draw.maps.x * inversesqrt(longest);
    return normalize(scale * (lean.x * alongU - lean.y * alongV) + max(lean.z, 0.05) * n);
}

void main() {
    const vec3 across = cross(dFdx(inFromEye), dFdy(inFromEye));   // before any pixel of the quad is left
    const vec4 base = draw.baseColor * inColor * texture(baseColorMap, inUv);
    if (masked && base.a < draw.emissive.w) demote;   // the next look wants the whole quad
    if (dithered && base.a < ditherThreshold(gl_FragCoord.xy, draw.emissive.w, length(inFromEye))) demote;
    if (unlit) {
        outColor = vec4(fogged(base.rgb, inFromEye), 1.0);
        return;
    }
    const vec4 mr = texture(surfaceMap, uvOf(1));
    // What metal mirrors in water is the water and the bed around it, no sky: as bright as what is matte and of its colour.
    const float inWater = shareInWater(inFromEye);
    const float metallic = (1.0 - inWater) * draw.surface.x * mr.b;
    float roughness = clamp(draw.surface.y * mr.g, 0.06, 1.0);
    vec3 f0 = mix(vec3(0.04), base.rgb, metallic);
    vec3 diffuse = base.rgb * (1.0 - metallic);
    if (specularGlossiness) {
        roughness = clamp(1.0 - (1.0 - draw.surface.y) * mr.a, 0.06, 1.0);
        f0 = draw.specular.rgb * mr.rgb;
        diffuse = base.rgb * (1.0 - max(f0.r, max(f0.g, f0.b)));
    }

    const vec2 wet = wetnessOf(inFromEye, roughness);
    diffuse = seaglass_wetAlbedo(diffuse, wet);
    roughness = seaglass_wetRoughness(roughness, wet);
    f0 *= 1.0 - 0.5 * wet.x;   // of index 1.33, not 1.5

    vec3 n = normalize(inNormal);
    if (!gl_FrontFacing) n = -n;
    if (hasNormalMap) n = mappedNormal(n, across);
    const vec3 v = -normalize(inFromEye * frame.sight.w + frame.sight.xyz);
    const vec3 l = frame.toSun.xyz;
    const float nDotL = facingSun(inFromEye, n), nDotV = max(abs(dot(n, v)), 1e-3);

    // Of index 1.5, which mirrors a tenth as much in water as in air.
    const float mirrors = mix(1.0, 0.087, inWater);

    vec3 radiance = draw.emissive.rgb;
    if (hasEmissiveMap) radiance *= texture(emissiveMap, uvOf(2)).rgb;
    if (nDotL > 0.0) {
        const vec3 sun = frame.sunIrradiance.rgb * (nDotL * sunVisibility(inFromEye, facetNormal(across, n), n));
        radiance += sun * (diffuse / pi + mirrors * sunSpecular(n, v, l, nDotL, nDotV, f0, roughness));
    }
    const vec3 ambient = mirrors * environmentBrdf(f0, roughness, nDotV);
    // The mip whose texels are as large as the lobe: solid angles 4 pi alpha^2 and 4 pi / (6 size^2).
    const float mip = log2(frame.sky.w * roughness * roughness * 2.449);
    const vec3 mirror = reflect(-v, n);
    vec3 mirrored = vec3(0.0);
    if (inWater < 1.0) mirrored += (1.0 - inWater) * textureLod(skyCube, mirror, clamp(mip, 0.0, frame.sky.z - 1.0)).rgb;
    if (inWater > 0.0) mirrored += inWater * facingSky(inFromEye, mirror) / pi;
    const vec3 around = diffuse / pi * facingSky(inFromEye, n) * (1.0 - ambient) + mirrored * ambient;
    radiance += hasOcclusionMap ? around * mix(1.0, texture(occlusionMap, uvOf(4)).r, draw.maps.y) : around;
    outColor = vec4(fogged(min(radiance, vec3(60000.0)), inFromEye), 1.0);
}
