// One triangle over what may lie below the calm surface: from above it, all that lines of sight show which point down.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "one_view.glsl"
#include "body.glsl"
#include "body_sight.glsl"

// How much a line of sight rises, in some unit: linear in the pixels.
float rise(vec2 pixel) {
    return dot(calmNormal(), alongSightOf(pixel));
}

void main() {
    if (isOtherView()) {
        gl_Position = outOfSight;
        return;
    }
    const float beyond = 1.5;   // half the picture's diagonal, and more
    vec2 size = vec2(regionSize());
    float right = rise(vec2(size.x, 0.0)), low = rise(vec2(0.0, size.y));
    float middle = 0.5 * (right + low);
    vec2 falls = 0.5 * (vec2(rise(vec2(0.0))) - vec2(right, low));
    float steep = length(falls);
    bool lineInSight = calmLevel() < 0.0 && !sightIsParallel() && abs(middle) < beyond * steep;
    vec2 down = lineInSight ? falls / steep : vec2(0.0, 1.0);
    float from = lineInSight ? middle / steep - 4.0 / min(size.x, size.y) : -beyond;
    // Of the horizon's line to both sides, and down; at three from it, the far side of the picture, still as wide as that is.
    vec2 corner = gl_VertexIndex == 0 ? vec2(3.0, 0.0) : gl_VertexIndex == 1 ? vec2(-3.0, 0.0) : vec2(0.0, 6.0);
    gl_Position = vec4(corner.x * vec2(-down.y, down.x) + (from + corner.y) * down, 0.0, 1.0);
}
