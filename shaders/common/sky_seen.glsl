// The sky of the host: its cube, or its colours. Needs surface_uniforms.glsl, and `tilted`.
#include "sky_colors.glsl"

layout(constant_id = 16) const bool skyHasColors = false;   // in place of the cube, which is then not read

// Functions of their own: where the sky has colours they are cut out of the shader (water/surface.cpp).
vec3 cubeAt(vec3 direction, float mip) {
    return textureLod(skyCube, direction, mip).rgb;
}

// A host may say more than its view has.
float cubeMips() {
    return min(skyMips, float(textureQueryLevels(skyCube)));
}
