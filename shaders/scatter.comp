// SSPR, first pass: every scene pixel above the plane leaves its mirrored depth where the plane would show it. Only
// depth is stored, since the mirror is an involution and leads back to the source; atomicMax commutes, so the result
// does not depend on the order of the invocations. Tiles are told where the plane is seen and where keys fell, so that
// the resolve runs where there is something to resolve.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mirror.glsl"
#include "tiles.glsl"

// An invocation takes a column of one tile.
layout(local_size_x = 64, local_size_y = 1) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) buffer Keys {
    uint keys[];
};
layout(set = 0, binding = 3, std430) buffer Tiles {
    TileHeader header;
    uint tiles[];
};

void main() {
    ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, tileEdge);
    if (first.x >= region.z) return;
    // All four are affine in (x, y, depth): only the depth's share is left for the loop.
    vec2 corner = vec2(first) + 0.5;
    vec4 target = screenMirror * vec4(corner, 0.0, 1.0);
    float height = dot(heightRow, vec4(corner, 0.0, 1.0));
    float weight = dot(weightRow, vec4(corner, 0.0, 1.0));
    bool planeSeen = false;
    int keyTile = -1;
    int rows = min(tileEdge, region.w - first.y);
    for (int row = 0; row < rows; ++row) {
        float depth = texelFetch(sceneDepth, region.xy + first + ivec2(0, row), 0).r;
        bool far = isFar(depth);
        // The plane goes on behind a far plane.
        float reach = far ? infinityDepth : depth;
        float h = height + heightRow.z * reach;
        float w = weight + weightRow.z * reach;
        vec4 q = target + screenMirror[2] * depth;
        target += screenMirror[1];
        height += heightRow.y;
        weight += weightRow.y;
        if (onOrBelowPlane(h, w)) {
            planeSeen = true;
            continue;
        }
        vec3 mirroredPoint = q.xyz / q.w;
        if (far || !(q.w > 0.0) || !(mirroredPoint.z > 0.0 && mirroredPoint.z <= 1.0) ||
            !insideRegion(mirroredPoint.xy))
            continue;
        ivec2 pixel = ivec2(mirroredPoint.xy);
        atomicMax(keys[pixel.y * region.z + pixel.x], keyFromDepth(mirroredPoint.z));
        int tile = tileAt(pixel / tileEdge);
        if (tile != keyTile) atomicOr(tiles[tile], tileHasKeys);
        keyTile = tile;
    }
    if (planeSeen) atomicOr(tiles[tileAt(first / tileEdge)], tileSeesPlane);
}
