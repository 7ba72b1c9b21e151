// A polished surface: a diffuse ground under a clear, flat coat that mirrors the scene.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "mirror.glsl"
#include "sunlight.glsl"
#include "reflection_info.glsl"
#include "reflection_source.glsl"

layout(set = 0, binding = 1) uniform samplerCube skyCube;
layout(set = 1, binding = 1) uniform sampler2D ground;
layout(set = 1, binding = 2) uniform sampler2D reflectionColor;
layout(set = 1, binding = 3) uniform sampler2D reflectionInfo;

#include "air.glsl"
#include "reflection_blur.glsl"
#include "reflection_texels.glsl"

// Constants, not uniforms: a driver that compiles a shader for uniforms' values, as llvmpipe does where that halves it, would
// do so at each draw.
layout(constant_id = 0) const int shownOutput = 0;   // the program's --aov, as host.h numbers them; colour for depth
layout(constant_id = 1) const bool sceneIsMirrored = true;

layout(location = 0) in vec3 inFromEye;
layout(location = 1) in vec2 inUv;

layout(location = 0) out vec4 outColor;

const int aovReflection = 1;
const int aovClass = 2;
const int aovNormal = 4;
const int aovColor = 0;
const int aovSource = 7;

const float farAway = 1e5;   // [m]

float infoHere() {
    return sceneIsMirrored ? texelFetch(reflectionInfo, ivec2(gl_FragCoord.xy) / int(mirror.picture.z), 0).x : infoUnknown;
}

vec3 classColor(float info) {
    if (infoIsHit(info)) return vec3(0.0, 1.0, 0.0);
    return infoIsSky(info) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
}

Ray rayThrough(vec2 pixel) {
    const vec2 at = 2.0 * pixel / mirror.picture.xy - 1.0;
    return Ray(vec3(0.0), normalize(frame.skyForward.xyz + at.x * frame.skyRight.xyz - at.y * frame.skyUp.xyz));
}

// Where in the picture what is mirrored here is taken from, its distance from the floor and its ReflectionClass, as
// seaglass::SurfaceOutput has it of water.
vec4 sourceHere() {
    if (!sceneIsMirrored) return vec4(-1.0, -1.0, 0.0, 1.0);
    const float info = infoHere();
    if (!infoIsHit(info)) return vec4(-1.0, -1.0, 0.0, infoIsSky(info) ? 1.0 : 0.0);
    const float downscale = mirror.picture.z;
    const Ray throughTexel = rayThrough((floor(gl_FragCoord.xy / downscale) + 0.5) * downscale);
    const vec3 n = mirror.normal.xyz;
    const vec3 source = mirroredPoint(Ray(vec3(0.0), normalize(inFromEye)), throughTexel, info, n, -dot(n, mirror.middle.xyz));
    const vec4 seen = frame.clipFromEye * vec4(source, 1.0);
    return seen.w > 0.0 ? vec4((0.5 + 0.5 * seen.xy / seen.w) * mirror.picture.xy, info, 2.0) : vec4(-1.0, -1.0, info, 2.0);
}

// The mip whose texels are as large as the lobe: solid angles 4 pi alpha^2 and 4 pi / (6 size^2).
vec3 skyAlong(vec3 direction, float roughness) {
    const float mip = log2(max(frame.sky.w * roughness * roughness * 2.449, 1.0));
    return textureLod(skyCube, direction, clamp(mip, 0.0, frame.sky.z - 1.0)).rgb;
}

// A flat mirror needs no bent lookup: the reflection image holds at each pixel what is mirrored there. The farther the
// rays of a rough one go, the more of it they meet: the lobe's solid angle is 4 pi alpha^2 cos, as seen from the mirror.
vec4 sceneHere(float cosine, float roughness) {
    if (!sceneIsMirrored) return vec4(0.0);
    const float info = infoHere();
    const float distance = infoIsHit(info) ? info : farAway;
    const float cone = 3.545 * roughness * roughness * sqrt(cosine);
    const float downscale = mirror.picture.z;
    const float toMirror = length(inFromEye);
    const float width = bundleWidth(cone, distance, mirror.blur.xyz);
    const float mip = bundleMip(bundleTexels(width, toMirror, distance, mirror.color.w / downscale));
    return reflectionTexel(reflectionColor, reflectionInfo, gl_FragCoord.xy / downscale, mip, downscale) * shareOfScene(distance, mirror.blur.xyz);
}

// Of a rough surface in even light: Schlick's at the facets that are seen, which face the eye more than the surface does, less
// what they hide of each other. Fitted to means over visible facets of GGX (Heitz 2018): off by a tenth of those, root mean square.
float fresnel(float f0, float roughness, float cosine) {
    const float facing = min(sqrt(cosine * cosine + 0.25 * pow(roughness, 1.66)), 1.0);
    return (f0 + (1.0 - f0) * pow(1.0 - facing, 5.0)) / (1.0 + 1.3 * roughness * roughness * roughness);
}

void main() {
    if (shownOutput == aovSource) {
        outColor = sourceHere();
        return;
    }
    const vec4 polished = texture(ground, inUv);
    const vec3 diffuse = mirror.color.rgb * polished.rgb;
    const float f0 = mirror.middle.w, roughness = mirror.normal.w;
    const vec3 n = mirror.normal.xyz, v = normalize(-inFromEye), l = frame.toSun.xyz;
    const float nDotL = dot(n, l), nDotV = max(dot(n, v), 1e-3);

    const vec4 scene = sceneHere(nDotV, roughness);
    const vec3 upwards = reflect(-v, n);
    const vec3 mirrored = foggedSky(skyAlong(upwards, roughness), inFromEye.y, upwards) * (1.0 - scene.a) + scene.rgb;
    if (shownOutput != aovColor) {
        vec3 shown = vec3(0.0);
        if (shownOutput == aovReflection) shown = mirrored;
        if (shownOutput == aovClass && sceneIsMirrored) shown = classColor(infoHere());
        if (shownOutput == aovNormal) shown = n;
        outColor = vec4(shown, 1.0);
        return;
    }
    vec3 light = skyIrradiance(n), glint = vec3(0.0);
    if (nDotL > 0.0) {
        const vec3 sun = frame.sunIrradiance.rgb * (nDotL * sunVisibility(inFromEye, n, n));
        light += sun;
        // No mirror is sharper than the sun's disc is wide.
        glint = sun * sunSpecular(n, v, l, nDotL, nDotV, vec3(f0), max(roughness, 0.06));
    }
    const float coat = polished.a * fresnel(f0, roughness, nDotV);
    const vec3 radiance = diffuse / pi * light * (1.0 - coat) + mirrored * coat + glint * polished.a;
    outColor = vec4(min(radiance, vec3(60000.0)), 1.0);
    if (fogShape() == 0) return;
    // What the scene's picture shows has the fog before it already: of it only what it differs from that by counts.
    const vec4 air = airBefore(inFromEye);
    outColor.rgb = mix(air.rgb + coat * (scene.rgb - scene.a * air.rgb), outColor.rgb, air.a);
}
