// What a body covers of its plane: water/mesh/extent.h. The edges of an outline near a patch, (u, v) relative to the eye.
#ifndef EXTENT_GLSL
#define EXTENT_GLSL

#include "body.glsl"

layout(set = 0, binding = extentBinding, std430) readonly buffer Extent {
    vec4 outlineBox;   // lowest and highest (u, v)
    vec4 edges[];      // (u, v) of both ends
};

// Each edge of a closed outline that the ray from a point towards -u crosses leads from without to isIn, or back. Ends
// are compared as they are held, so that each belongs to one of its two edges.
bool isWithin(vec2 point, uvec2 range) {
    bool isIn = range.y == 0u;
    for (uint i = 0u; i < range.y; ++i) {
        vec4 e = edges[range.x + i];
        bool spans = (e.y <= point.y) != (e.w <= point.y);
        float across = e.x + (point.y - e.y) / (e.w - e.y) * (e.z - e.x);
        isIn = isIn != (spans && across < point.x);
    }
    return isIn;
}

// Of their way to the side, how much waves move a point: nothing at the edge, where there may be a wall.
float loosenessAt(float fromEdge) {
    return min(fromEdge * water.perEdgeWidth, 1.0);
}

float looseness(vec2 point, uvec2 range) {
    float least = 1e30;
    for (uint i = 0u; i < range.y; ++i) {
        vec4 e = edges[range.x + i];
        vec2 along = e.zw - e.xy, away = point - e.xy;
        vec2 past = away - along * clamp(dot(away, along) / dot(along, along), 0.0, 1.0);
        least = min(least, dot(past, past));
    }
    return loosenessAt(sqrt(least));
}

#endif
