// Ellipses on a plane.
#ifndef FOOTPRINT_GLSL
#define FOOTPRINT_GLSL

// The longer half axis and the shorter one of the ellipse that two steps span, as those from a pixel to the next do on the calm
// plane [m].
struct Footprint {
    vec2 longer, shorter;
    float reach;   // length of the longer
};

Footprint footprintOf(vec2 right, vec2 down) {
    float uu = right.x * right.x + down.x * down.x;
    float vv = right.y * right.y + down.y * down.y;
    float uv = right.x * right.y + down.x * down.y;
    float halfGap = 0.5 * (uu - vv);
    float apart = sqrt(halfGap * halfGap + uv * uv);
    float middle = 0.5 * (uu + vv);
    vec2 along = halfGap > 0.0 ? vec2(halfGap + apart, uv) : vec2(uv, apart - halfGap);
    along /= max(length(along), 1e-20);
    float reach = sqrt(middle + apart);
    return Footprint(along * reach, vec2(-along.y, along.x) * sqrt(max(middle - apart, 0.0)), reach);
}

#endif
