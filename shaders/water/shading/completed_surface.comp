// Completes a surface of which one pixel of 2 or of 4 was shaded: each other pixel is a mean of those around it that were, in which
// the more counts what lies on the same wave. A group a tile, an invocation a block.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "constant.glsl"
#include "surface_tiles_constants.h"
#include "water_bindings.h"
#include "body.glsl"
#include "found_tiles_block.h"
#include "found_surface.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = foundDepthBinding) uniform sampler2D foundDepth;
layout(set = 0, binding = shadedBinding, rgba16f) uniform image2D shadedColor;

#include "found_tiles.glsl"
#include "shaded_pixels.glsl"

struct Mean {
    vec3 sum;
    float weights;
};

// By how much farther or nearer it lies: from row to row of water that is seen flatly that is more than along a row, and from a crest
// to what it hides it is most.
void addShaded(inout Mean mean, ivec2 at, float depth, int away) {
    if (!showsSurface(at)) return;
    float apart = texelFetch(foundDepth, at, 0).r / depth - 1.0;
    float counts = 1.0 / ((1e-4 + apart * apart) * float(away));
    mean.sum += counts * imageLoad(shadedColor, at).rgb;
    mean.weights += counts;
}

// By those that are shaded to the left and to the right, and in the rows above and below.
vec3 completed(ivec2 at, ivec2 shaded) {
    float depth = texelFetch(foundDepth, at, 0).r;
    int every = int(pixelsPerShading);
    int left = (at.x + every - shiftOfRow(at.y)) % every;
    int across = every / 2 - left;
    Mean mean = Mean(vec3(0.0), 0.0);
    addShaded(mean, at - ivec2(left, 0), depth, left);
    addShaded(mean, at + ivec2(every - left, 0), depth, every - left);
    addShaded(mean, at + ivec2(across, -1), depth, 1 + abs(across));
    addShaded(mean, at + ivec2(across, 1), depth, 1 + abs(across));
    return mean.weights > 0.0 ? mean.sum / mean.weights : imageLoad(shadedColor, shaded).rgb;
}

void main() {
    int tile = int(gl_WorkGroupID.y * foundGroupsPerRow + gl_WorkGroupID.x);
    bool shows = tile < tileCount() && tiles[placeOfNeeds(min(tile, tileCount() - 1))] > 0u;
    ivec2 place = ivec2(gl_LocalInvocationIndex & 7u, gl_LocalInvocationIndex >> 3);
    ivec2 block = firstPixel(heldTile(tile)) / blockSize() + place;
    ivec2 shaded = shadedPixel(block);
    int rounds = shows ? blockSize().x : 0;
    for (int i = 0; i < rounds; ++i) {
        ivec2 at = block * blockSize() + ivec2(i, 0);
        if (at != shaded && showsSurface(at)) imageStore(shadedColor, at, vec4(completed(at, shaded), 1.0));
    }
}
