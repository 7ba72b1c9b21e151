// The sky of the host: its cube, or its colours. Needs body.glsl, and `tilted`.
#include "sky_colors.glsl"

vec3 cubeAt(vec3 direction, float mip) {
    return textureLod(skyCube, direction, mip).rgb;
}

// A host may say more than its view has.
float cubeMips() {
    return min(water.skyMips, float(textureQueryLevels(skyCube)));
}
