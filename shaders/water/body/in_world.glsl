// Of directions in a body's axes what the host knows: the sky cube's and normals.
#ifndef IN_WORLD_GLSL
#define IN_WORLD_GLSL

#include "body.glsl"

vec3 inWorld(vec3 direction) {
    return tilted ? mat3(water.worldFromBody) * direction : direction;
}

#endif
