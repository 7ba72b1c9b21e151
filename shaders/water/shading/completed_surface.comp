// Completes a surface of which one pixel of 2 or of 4 was shaded: each other pixel is a mean of those around it that were, in which
// the more counts what lies on the same wave. A group a tile, an invocation a block.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "body.glsl"
#include "found_surface.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = shadedBinding, rgba16f) uniform image2D shadedColor;

#include "shading_block.glsl"
#include "found_tiles.glsl"
#include "shaded_pixels.glsl"

// Of one of 4 those of a row are farther apart than those of the rows beside, and tell less of where edges lie.
const float sameDepth = blockWidth == 2 ? 3e-5 : 1e-4;
const float alike = blockWidth == 2 ? 0.01 : 100.0;

// What is shaded on either side of a pixel.
struct Pair {
    vec3 sum;
    float weights;
    float apart;   // how much their colours differ, as a share; 1 where one of both is missing
};

// A colour, and how much it counts, by how much farther or nearer it lies: from row to row of water that is seen flatly that is more
// than along a row, and from a crest to what it hides it is most.
vec4 shadedAt(ivec2 at, float depth, int away) {
    float there = foundDepthAt(at);
    if (there <= 0.0) return vec4(0.0);
    float apart = there / depth - 1.0;
    return vec4(imageLoad(shadedColor, at).rgb, 1.0 / ((sameDepth + apart * apart) * float(away)));
}

Pair pairOf(vec4 one, vec4 other) {
    vec3 differs = abs(one.rgb - other.rgb), all = one.rgb + other.rgb + 1e-4;
    float apart = (differs.r + differs.g + differs.b) / (all.r + all.g + all.b);
    return Pair(one.a * one.rgb + other.a * other.rgb, one.a + other.a, one.a * other.a > 0.0 ? apart : 1.0);
}

// By those that are shaded to the left and to the right, and in the rows above and below: more by the pair that is alike, which lies
// along an edge. Across it a line of one row would become dots.
vec3 completed(ivec2 at, float depth, ivec2 shaded) {
    int left = (at.x + blockWidth - shiftOfRow(at.y)) % blockWidth;
    int right = blockWidth - left;
    int aside = blockWidth / 2 - left;
    Pair row = pairOf(shadedAt(at - ivec2(left, 0), depth, left), shadedAt(at + ivec2(right, 0), depth, right));
    Pair column = pairOf(shadedAt(at + ivec2(aside, -1), depth, 1 + abs(aside)), shadedAt(at + ivec2(aside, 1), depth, 1 + abs(aside)));
    float ofRow = alike + column.apart * column.apart, ofColumn = alike + row.apart * row.apart;
    float weights = ofRow * row.weights + ofColumn * column.weights;
    return weights > 0.0 ? (ofRow * row.sum + ofColumn * column.sum) / weights : imageLoad(shadedColor, shaded).rgb;
}

void main() {
    int tile = int(gl_WorkGroupID.y * foundGroupsPerRow + gl_WorkGroupID.x);
    bool shows = tile < tileCount() && tiles[placeOfNeeds(min(tile, tileCount() - 1))] > 0u;
    ivec2 place = ivec2(gl_LocalInvocationIndex & 7u, gl_LocalInvocationIndex >> 3);
    ivec2 block = firstPixel(heldTile(tile)) / blockSize() + place;
    ivec2 shaded = shadedPixel(block);
    ivec2 first = block * blockSize();
    int others = blockWidth - 1, i = 0;
    [[dont_unroll]] do {
        ivec2 at = first + ivec2((shaded.x - first.x + 1 + i) & others, 0);
        float depth = foundDepthAt(at);
        if (shows && depth > 0.0) imageStore(shadedColor, at, vec4(completed(at, depth, shaded), 1.0));
    } while (++i < others);
}
