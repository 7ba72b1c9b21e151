// One halving of the reflection's pyramid: 4 x 4 texels under the weights 1 3 3 1, whose repetition tends to a Gaussian
// (Burt and Adelson 1983); means of 2 x 2 would show as squares. Colour is premultiplied by confidence, so the mean of a
// hole and a hit is half a hit, and neither sky nor unknown bleed in.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "reflection_bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = finerMipBinding) uniform sampler2D finer;   // linear
layout(set = 0, binding = coarserMipBinding, rgba16f) uniform writeonly image2D coarser;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(coarser)))) return;
    vec2 texel = 1.0 / vec2(textureSize(finer, 0));
    vec2 middle = (vec2(pixel) + 0.5) / vec2(imageSize(coarser));
    // A quarter off the middle between two texels they weigh 1 and 3.
    vec2 least = middle - 0.75 * texel;
    vec2 most = middle + 0.75 * texel;
    vec4 sum = textureLod(finer, least, 0.0) + textureLod(finer, vec2(most.x, least.y), 0.0) +
               textureLod(finer, vec2(least.x, most.y), 0.0) + textureLod(finer, most, 0.0);
    imageStore(coarser, pixel, 0.25 * sum);
}
