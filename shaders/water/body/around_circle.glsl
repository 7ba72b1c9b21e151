// Triangles around what is round.
#ifndef AROUND_CIRCLE_GLSL
#define AROUND_CIRCLE_GLSL

// The corners of one whose sides touch the unit circle.
vec2 aroundCircle(int corner) {
    return corner == 0 ? vec2(-1.7320508, -1.0) : corner == 1 ? vec2(1.7320508, -1.0) : vec2(0.0, 2.0);
}

#endif
