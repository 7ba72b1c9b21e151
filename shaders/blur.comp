// One halving of the reflection's pyramid: 4 x 4 texels under the weights 1 3 3 1, whose repetition tends to a Gaussian
// (Burt and Adelson 1983); means of 2 x 2 would show as squares. Colour is premultiplied by confidence, so the mean of a
// hole and a hit is half a hit, and neither sky nor unknown bleed in.
#version 450

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D finer;   // linear
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D coarser;

bool isFinite(vec4 value) {
    return !any(isnan(value)) && !any(isinf(value));
}

// A linear sample a quarter off the middle between two texels weighs them 1 and 3.
vec4 weighted(vec2 middle, vec2 texel) {
    const float off = 0.75;
    vec2 least = (middle - off) * texel;
    vec2 most = (middle + off) * texel;
    return 0.25 * (textureLod(finer, least, 0.0) + textureLod(finer, vec2(most.x, least.y), 0.0) +
                   textureLod(finer, vec2(least.x, most.y), 0.0) + textureLod(finer, most, 0.0));
}

// Without the texels that are not finite: a broken pixel of the host's stays one.
vec4 weightedFinite(vec2 middle, ivec2 size) {
    const float weights[4] = float[](0.125, 0.375, 0.375, 0.125);
    ivec2 first = ivec2(middle) - 2;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            vec4 value = texelFetch(finer, clamp(first + ivec2(x, y), ivec2(0), size - 1), 0);
            if (isFinite(value)) sum += weights[x] * weights[y] * value;
        }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(coarser)))) return;
    ivec2 size = textureSize(finer, 0);
    vec2 middle = (vec2(pixel) + 0.5) * vec2(size) / vec2(imageSize(coarser));
    vec4 color = weighted(middle, 1.0 / vec2(size));
    // A loop of one round: CPU devices leave it out where nobody is in it.
    for (bool broken = !isFinite(color); broken; broken = false) color = weightedFinite(middle, size);
    imageStore(coarser, pixel, color);
}
