#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "draw.glsl"

layout(constant_id = 0) const bool masked = false;

layout(set = 0, binding = 1) uniform samplerCube skyCube;
layout(set = 0, binding = 3) uniform sampler2DShadow shadowMap;
layout(set = 1, binding = 0) uniform sampler2D baseColorMap;
layout(set = 1, binding = 1) uniform sampler2D metallicRoughnessMap;

layout(location = 0) in vec3 inFromEye;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;

layout(location = 0) out vec4 outColor;

const float pi = 3.14159265;

// Percentage-closer filtering under a 5x5 tent from nine bilinear taps (Castano 2013, "Shadow Mapping Summary").
// `uv` runs over one cascade; the four are quarters of the map.
float filteredShadow(int cascade, vec2 uv, float depth) {
    const float texel = frame.shadow.x;
    const vec2 at = uv / texel + 0.5;
    const vec2 base = floor(at), st = at - base;
    const vec2 corner = vec2(cascade & 1, cascade >> 1) * 0.5;
    const vec2 w0 = 4.0 - 3.0 * st, w2 = 1.0 + 3.0 * st;
    const vec2 p0 = (3.0 - 2.0 * st) / w0 - 2.0, p1 = (3.0 + st) / 7.0, p2 = st / w2 + 2.0;
    const vec3 wu = vec3(w0.x, 7.0, w2.x), wv = vec3(w0.y, 7.0, w2.y);
    const vec3 pu = vec3(p0.x, p1.x, p2.x), pv = vec3(p0.y, p1.y, p2.y);
    float sum = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const vec2 tap = (base - 0.5 + vec2(pu[i], pv[j])) * texel;
            sum += wu[i] * wv[j] * texture(shadowMap, vec3(corner + 0.5 * tap, depth));
        }
    return sum / 144.0;
}

float sunVisibility(vec3 fromEye, vec3 normal, float nDotL) {
    const float sine = sqrt(max(0.0, 1.0 - nDotL * nDotL));
    int chosen = -1;
    vec3 at = vec3(0.0);
    // From far to near: the nearest that holds the point wins. Chosen first and filtered once, since a device that
    // masks branches would pay for each.
    for (int cascade = 3; cascade >= 0; --cascade) {
        const float texelM = frame.shadowTexelM[cascade];
        // Under a filter of radius r a plane seen at an angle rises by r * sin: lifting the receiver along its normal
        // by that much ends acne without a bias in depth.
        const vec3 receiver = fromEye + normal * (texelM * (2.5 * sine + 0.1));
        const vec3 clip = (frame.shadowFromEye[cascade] * vec4(receiver, 1.0)).xyz;
        // The filter must not reach into the neighbouring cascade.
        const bool inside = max(abs(clip.x), abs(clip.y)) < 1.0 - 8.0 * frame.shadow.x;
        if (texelM > 0.0 && inside) {
            chosen = cascade;
            at = clip;
        }
    }
    return chosen < 0 ? 1.0 : filteredShadow(chosen, at.xy * 0.5 + 0.5, at.z);
}

// Specular reflectance of a rough surface in uniform light (Karis 2014, "Physically Based Shading on Mobile").
vec3 environmentBrdf(vec3 f0, float roughness, float nDotV) {
    const vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    const float a = min(r.x * r.x, exp2(-9.28 * nDotV)) * r.x + r.y;
    const vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
    return f0 * ab.x + ab.y;
}

// GGX with the height-correlated Smith term (Heitz 2014), Fresnel by Schlick.
vec3 sunSpecular(vec3 n, vec3 v, vec3 l, float nDotL, float nDotV, vec3 f0, float roughness) {
    const vec3 h = normalize(v + l);
    const float nDotH = clamp(dot(n, h), 0.0, 1.0), vDotH = clamp(dot(v, h), 0.0, 1.0);
    const float alpha = roughness * roughness, a2 = alpha * alpha;
    const float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
    const float smith = nDotL * sqrt(nDotV * nDotV * (1.0 - a2) + a2) + nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2);
    const vec3 f = f0 + (1.0 - f0) * pow(1.0 - vDotH, 5.0);
    return f * (a2 / (pi * d * d)) * (0.5 / max(smith, 1e-5));
}

void main() {
    const vec4 base = draw.baseColor * inColor * texture(baseColorMap, inUv);
    if (masked && base.a < draw.emissive.w) discard;
    const vec4 mr = texture(metallicRoughnessMap, inUv);
    const float metallic = draw.surface.x * mr.b;
    const float roughness = clamp(draw.surface.y * mr.g, 0.06, 1.0);
    const vec3 f0 = mix(vec3(0.04), base.rgb, metallic);
    const vec3 diffuse = base.rgb * (1.0 - metallic);

    vec3 n = normalize(inNormal);
    if (!gl_FrontFacing) n = -n;
    const vec3 v = normalize(-inFromEye);
    const vec3 l = frame.toSun.xyz;
    const float nDotL = dot(n, l), nDotV = max(abs(dot(n, v)), 1e-3);

    vec3 radiance = draw.emissive.rgb;
    if (nDotL > 0.0) {
        const vec3 sun = frame.sunIrradiance.rgb * (nDotL * sunVisibility(inFromEye, n, nDotL));
        radiance += sun * (diffuse / pi + sunSpecular(n, v, l, nDotL, nDotV, f0, roughness));
    }
    const vec3 ambient = environmentBrdf(f0, roughness, nDotV);
    // The mip whose texels are as large as the lobe: solid angles 4 pi alpha^2 and 4 pi / (6 size^2).
    const float mip = log2(frame.sky.w * roughness * roughness * 2.449);
    const vec3 mirrored = textureLod(skyCube, reflect(-v, n), clamp(mip, 0.0, frame.sky.z - 1.0)).rgb;
    radiance += diffuse / pi * skyIrradiance(n) * (1.0 - ambient) + mirrored * ambient;
    outColor = vec4(min(radiance, vec3(60000.0)), 1.0);
}
