// One view of a body, as its shaders are given it.
#include "body_block.h"

layout(set = 0, binding = bodyBinding, std140) uniform Body {
    BodyBlock water;
};

// To a point along the line of sight on which it lies, of any length.
vec3 sightTo(vec3 at) {
    return at * water.sight.w + water.sight.xyz;
}

// How far away a point lies; of parallel lines, beyond the eye's own place on them.
float distanceTo(vec3 at) {
    return length(at * water.sight.w) + dot(at, water.sight.xyz);
}

// (x, y, depth) of a point in the region's pixels; w <= 0 behind the camera.
vec4 pixelOf(vec3 position) {
    vec4 p = water.pixelFromRelative * vec4(position, 1.0);
    return vec4(p.xyz / p.w, p.w);
}

// Across the line of sight, of a square as large as a pixel that shows the point [m].
float pixelWidth(vec3 at) {
    mat4 rows = transpose(water.pixelFromRelative);
    vec4 p = pixelOf(at);
    vec3 right = rows[0].xyz - p.x * rows[3].xyz;
    vec3 down = rows[1].xyz - p.y * rows[3].xyz;
    return p.w * inversesqrt(length(cross(right, down)));
}
