// Sines of angles that may be large. Vulkan bounds the error of sin and cos for half a turn either way alone.
#ifndef TURNS_GLSL
#define TURNS_GLSL

vec3 withinHalfTurn(vec3 turns) {
    return 6.2831853 * (turns - round(turns));
}

vec2 cosineSine(float turns) {
    float angle = withinHalfTurn(vec3(turns)).x;
    return vec2(cos(angle), sin(angle));
}

#endif
