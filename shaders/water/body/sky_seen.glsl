// The sky of the host: its cube, or its colours. `tilted` is a constant of the includer's.
#ifndef SKY_SEEN_GLSL
#define SKY_SEEN_GLSL

#include "body.glsl"
#include "sky_colors.glsl"

vec3 cubeAt(vec3 direction, float mip) {
    return textureLod(skyCube, direction, mip).rgb;
}

// A host may say more than its view has.
float cubeMips() {
    return min(water.skyMips, float(textureQueryLevels(skyCube)));
}

#endif
