// Planar reflection: what the host drew with the mirrored camera already lies on the pixels where the plane shows it.
// Depth tells how far behind the mirror; where nothing was drawn the plane mirrors the sky.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "reflection_info.glsl"
#include "sight_line.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1, std140) uniform MirroredView {
    vec4 mirroredHeightRow; // with the mirrored projection's own depth
    vec4 mirroredWeightRow;
};
layout(set = 0, binding = 2) uniform sampler2D mirroredDepth;
layout(set = 0, binding = 3, rgba16f) uniform image2D reflectionColor;
layout(set = 0, binding = 4, r16f) uniform writeonly image2D reflectionInfo;

// Of what lies under the plane, drawn only where the oblique plane could not clip it: no more than this counts [m].
const float contact = 1e-3;

float drawnHeight(vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(mirroredHeightRow, p) / dot(mirroredWeightRow, p);
}

float infoOfDrawn(vec2 q, float depth) {
    float towardsPlane = sightLine(relativeFromPixel, q).towardsPlane;
    if (!(towardsPlane > 0.0)) return infoUnknown;
    if (isFar(depth)) return infoSky;
    float height = drawnHeight(vec3(q, depth));
    return height > -contact ? infoOfHit(height / towardsPlane) : infoUnknown;
}

void main() {
    loadMirror();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize()))) return;
    float info = infoOfDrawn(middleOf(pixel), texelFetch(mirroredDepth, pixel, 0).r);
    vec3 drawn = imageLoad(reflectionColor, pixel).rgb;
    imageStore(reflectionColor, pixel, infoIsHit(info) ? vec4(drawn, 1.0) : vec4(0.0));
    imageStore(reflectionInfo, pixel, vec4(info, 0.0, 0.0, 0.0));
}
