// What rays left of light on each texel, and how much they would have under calm water; where it is copied, in the
// place of their sums.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "body.glsl"
#include "caustics_constants.h"
#include "caustic_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = sceneDepthBinding) uniform sampler2D sceneDepth;
layout(set = 0, binding = causticSumsBinding, std430) buffer Sums {
    uint sums[];
};
layout(set = 0, binding = causticLightBinding, rg16f) uniform writeonly image2DArray gathered;

// Light, and 1 where there is a bed for it.
void leave(ivec2 texel, int i, vec2 light) {
    if (copies) sums[i] = packHalf2x16(light);
    else if (all(lessThan(texel, imageSize(gathered).xy))) imageStore(gathered, ivec3(texel, 0), vec4(light, 0.0, 0.0));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    int i = texel.y * rowLength() + texel.x;
    if (texel.x >= rowLength() || i >= sums.length()) return;
    bool lit = false;
    vec3 at;
    if (all(lessThan(texel, lightSize()))) lit = bedShownAt(sceneDepth, min(pixelOfTexel(texel), regionSize() - 1), at);
    leave(texel, i, vec2(float(sums[i]) / lightUnit, float(lit)));
}
