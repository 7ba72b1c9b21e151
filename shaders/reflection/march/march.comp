// Screen-space reflection (SSR): each pixel of the plane follows its mirrored ray over the picture until it goes behind
// what is seen there.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "encoding.glsl"
#include "edge_fade.glsl"
#include "reflection_info.glsl"
#include "tiles.glsl"
#include "march.glsl"

layout(set = 0, binding = reflectionColorBinding, rgba16f) uniform writeonly image2D reflectionColor;
layout(set = 0, binding = reflectionInfoBinding, r16f) uniform image2D reflectionInfo;
#include "tile_list.glsl"
#include "depth_quads.glsl"
#include "source_color.glsl"

#include "march_ray.glsl"

#ifdef OPEN
// As all of the picture that it completes.
vec3 mirroredBySurface(const MirrorBlock mirror, vec2 q, vec3 direction) {
    return reflect(direction, planeNormal(mirror));
}

// One that another technique knew nothing of, that shows it an underside, or sky beside what is mirrored.
ivec2 pixelToMarch(const MirrorBlock mirror) {
    ivec2 pixel = pixelToResolve(mirror);
    if (pixel == noPixel || !infoIsOpen(imageLoad(reflectionInfo, pixel).r)) return noPixel;
    return pixel;
}

// What lies beyond an underside does not show.
float metresToMarch(ivec2 pixel) {
    float known = imageLoad(reflectionInfo, pixel).r;
    return infoIsDoubt(known) ? min(hitOfDoubt(known), settings.longest) : settings.longest;
}
#else
layout(set = 0, binding = surfaceNormalsBinding) uniform sampler2D surfaceNormals;

// Kept above the plane, as what shades the surface keeps it.
vec3 mirroredBySurface(const MirrorBlock mirror, vec2 q, vec3 direction) {
    vec3 normal = texelFetch(surfaceNormals, sceneTexel(mirror, ivec2(q)), 0).xyz;
    float squared = dot(normal, normal);
    if (settings.hasNormals == 0u || !(squared > 0.01) || isinf(squared)) return reflect(direction, planeNormal(mirror));
    vec3 r = reflect(direction, normalize(normal));
    float up = dot(r, planeNormal(mirror));
    return normalize(r + planeNormal(mirror) * (max(abs(up), 1e-3) - up));
}

ivec2 pixelToMarch(const MirrorBlock mirror) {
    return pixelToResolve(mirror);
}

float metresToMarch(ivec2 pixel) {
    return settings.longest;
}
#endif

// Interleaved gradient noise (Jimenez 2014): 0..1, and evenly spread among neighbours.
float noiseAt(vec2 pixel) {
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

void main() {
    MirrorBlock mirror = storedMirror;
    ivec2 pixel = pixelToMarch(mirror);
    if (pixel == noPixel) return;
    vec2 q = middleOf(mirror, pixel);

    vec4 color = vec4(0.0);
    float info = infoUnknown;
    int worth = refused;
    SightLine sight = sightThrough(mirror, q);
    if (sight.towardsPlane > 0.0) {
        March found = marched(mirror, sight.onPlane, mirroredBySurface(mirror, q, sight.direction), metresToMarch(pixel),
                              noiseAt(vec2(pixel)));
        info = found.info;
        worth = found.worth;
        if (infoIsHit(info)) {
            float confidence = edgeConfidence(mirror, q, found.source.xy);
            float light = worth == underside ? confidence * mirror.undersideLight : confidence;
            color = vec4(sourceColor(mirror, found.source.xy, found.source.z) * light, confidence);
        }
    }
#ifdef OPEN
    float known = imageLoad(reflectionInfo, pixel).r;
    if (known != infoUnknown && worth < (infoIsDoubt(known) ? met : closely)) {
        imageStore(reflectionInfo, pixel, vec4(infoUndoubted(known), 0.0, 0.0, 0.0));
        return;
    }
#endif
    imageStore(reflectionColor, pixel, color);
    imageStore(reflectionInfo, pixel, vec4(info, 0.0, 0.0, 0.0));
}
