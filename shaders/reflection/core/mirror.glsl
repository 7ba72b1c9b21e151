// The screen mirror, and what pixels, keys and depths are to it: reflection/core/mirror.h.

#include "mirror_block.h"
#include "reflection_bindings.h"
#include "texel_at.glsl"

// main() loads it once and hands it on: CPU devices load uniforms anew at each use and in each turn of a loop.
layout(set = 0, binding = mirrorBinding, std140) uniform Mirror {
    MirrorBlock storedMirror;
};

// The reflection's pixels, and its keys'.
ivec2 reflectionSize(const MirrorBlock mirror) {
    return (mirror.region.zw + (1 << mirror.pixelShift) - 1) >> mirror.pixelShift;
}

ivec2 keyGrid(const MirrorBlock mirror) {
    return (mirror.region.zw + (1 << mirror.keyShift) - 1) >> mirror.keyShift;
}

// The middle of a pixel of the reflection, in the region's pixels.
vec2 middleOf(const MirrorBlock mirror, ivec2 imagePixel) {
    return (vec2(imagePixel) + 0.5) * float(1 << mirror.pixelShift);
}

const uint noKey = 0u;

// Relative to the eye.
vec3 unprojected(const MirrorBlock mirror, vec3 screenPoint) {
    vec4 p = mirror.relativeFromPixel * vec4(screenPoint, 1.0);
    return p.xyz / p.w;
}

// Heights under which a point counts as lying on the plane: what a depth buffer can no longer tell apart, 1 mm and what
// contactPerMetre says for each metre of distance, 20 micrometres or a step of the depth's format. Both sides of height <
// contact are linear in a screen point once they are multiplied by its weight, and so tell of points at infinity too:
// below the plane's horizon or above it.
vec4 aboveRow(const MirrorBlock mirror) {
    return mirror.heightRow - 1e-3 * mirror.weightRow - vec4(0.0, 0.0, 0.0, mirror.contactPerMetre);
}

bool onOrBelowPlane(const MirrorBlock mirror, vec3 screenPoint) {
    return dot(aboveRow(mirror), vec4(screenPoint, 1.0)) <= 0.0;
}

// Deeper under the plane than it is told apart.
bool wellBelowPlane(const MirrorBlock mirror, vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(mirror.heightRow, p) < -(1e-3 * dot(mirror.weightRow, p) + mirror.contactPerMetre);
}

bool insideRegion(const MirrorBlock mirror, vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, vec2(mirror.region.zw)));
}

bool isFar(const MirrorBlock mirror, float depth) {
    return mirror.depthSign * (depth - mirror.farDepth) <= 0.0;
}

// Positive floats order like their bits; the nearest mirrored point must win an atomicMax whichever way depth runs.
uint keyFromDepth(const MirrorBlock mirror, float depth) {
    uint bits = floatBitsToUint(depth);
    return mirror.depthSign > 0.0 ? bits : ~bits;
}

float depthFromKey(const MirrorBlock mirror, uint key) {
    return uintBitsToFloat(mirror.depthSign > 0.0 ? key : ~key);
}
