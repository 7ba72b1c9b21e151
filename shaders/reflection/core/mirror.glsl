// The screen mirror, and what pixels, keys and depths are to it: reflection/core/mirror.h.

#include "mirror_block.h"
#include "reflection_bindings.h"
#include "texel_at.glsl"

layout(set = 0, binding = mirrorBinding, std140) uniform Mirror {
    MirrorBlock storedMirror;
};

// Loaded once, before anything else: CPU devices load uniforms anew at each use and in each turn of a loop.
MirrorBlock mirror;

void loadMirror() {
    mirror = storedMirror;
}

// The reflection's pixels, and its keys'.
ivec2 imageSize() {
    return (mirror.region.zw + (1 << mirror.pixelShift) - 1) >> mirror.pixelShift;
}

ivec2 keyGrid() {
    return (mirror.region.zw + (1 << mirror.keyShift) - 1) >> mirror.keyShift;
}

// The middle of a pixel of the reflection, in the region's pixels.
vec2 middleOf(ivec2 imagePixel) {
    return (vec2(imagePixel) + 0.5) * float(1 << mirror.pixelShift);
}

const uint noKey = 0u;

// Relative to the eye.
vec3 unprojected(vec3 screenPoint) {
    vec4 p = mirror.relativeFromPixel * vec4(screenPoint, 1.0);
    return p.xyz / p.w;
}

// Heights under which a point counts as lying on the plane: what a depth buffer can no longer tell apart, 1 mm and what
// contactPerMetre says for each metre of distance, 20 micrometres or a step of the depth's format. Both sides of height <
// contact are linear in a screen point once they are multiplied by its weight, and so tell of points at infinity too:
// below the plane's horizon or above it.
vec4 aboveRow() {
    return mirror.heightRow - 1e-3 * mirror.weightRow - vec4(0.0, 0.0, 0.0, mirror.contactPerMetre);
}

bool onOrBelowPlane(vec3 screenPoint) {
    return dot(aboveRow(), vec4(screenPoint, 1.0)) <= 0.0;
}

// Deeper under the plane than it is told apart.
bool wellBelowPlane(vec3 screenPoint) {
    vec4 p = vec4(screenPoint, 1.0);
    return dot(mirror.heightRow, p) < -(1e-3 * dot(mirror.weightRow, p) + mirror.contactPerMetre);
}

bool insideRegion(vec2 pixel) {
    return all(greaterThanEqual(pixel, vec2(0.0))) && all(lessThan(pixel, vec2(mirror.region.zw)));
}

bool isFar(float depth) {
    return mirror.depthSign * (depth - mirror.farDepth) <= 0.0;
}

// Positive floats order like their bits; the nearest mirrored point must win an atomicMax whichever way depth runs.
uint keyFromDepth(float depth) {
    uint bits = floatBitsToUint(depth);
    return mirror.depthSign > 0.0 ? bits : ~bits;
}

float depthFromKey(uint key) {
    return uintBitsToFloat(mirror.depthSign > 0.0 ? key : ~key);
}
