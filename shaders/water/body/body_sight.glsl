// Along a body's lines of sight.
#ifndef BODY_SIGHT_GLSL
#define BODY_SIGHT_GLSL

#include "body.glsl"
#include "sight_line.glsl"

// Through a pixel of the region, away from the eye and of any length: linear in the pixels.
vec3 alongSightOf(vec2 pixel) {
    return alongSight(water.relativeFromPixel, water.relativeFromPixel * vec4(pixel, 0.5, 1.0), water.depthSign);
}

#endif
