// What rays left of light on each texel, and how much they would have under calm water.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface_uniforms.glsl"
#include "caustic_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D sceneDepth;
layout(set = 0, binding = 2, std430) readonly buffer Sums {
    uint sums[];
};
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D gathered;

void main() {
    loadSurface();
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = lightSize();
    if (any(greaterThanEqual(texel, imageSize(gathered)))) return;
    // The picture may be larger than the view.
    vec2 light = vec2(0.0);
    if (all(lessThan(texel, size))) {
        vec3 at;
        bool lit = bedShownAt(sceneDepth, min(pixelOfTexel(texel), region.zw - 1), at);
        light = vec2(float(sums[texel.y * size.x + texel.x]) / lightUnit, float(lit));
    }
    imageStore(gathered, texel, vec4(light, 0.0, 0.0));
}
