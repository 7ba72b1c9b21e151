// The sky of the host: its cube, or its colours.
#ifndef SKY_SEEN_GLSL
#define SKY_SEEN_GLSL

#include "body.glsl"
#include "sky_colors.glsl"

layout(set = 0, binding = skyCubeBinding) uniform samplerCube skyCube;

vec3 cubeAt(vec3 direction, float mip) {
    return textureLod(skyCube, direction, mip).rgb;
}

// A host may say more than its view has.
float cubeMips() {
    return min(water.skyMips, float(textureQueryLevels(skyCube)));
}

#endif
