// Reads a reflection of fewer pixels than the frame.
#include "reflection_info.glsl"

// Linear between texels, but for those of which nothing is known: at the foot of whatever stands before the mirror the
// next texel is one of that thing's, and would let the sky in along its edge.
vec4 knownBetween(sampler2D color, sampler2D info, vec2 texel) {
    const float least = 0.25;   // of weight, to fill what is missing
    vec2 corner = floor(texel - 0.5);
    vec2 share = texel - 0.5 - corner;
    ivec2 last = textureSize(color, 0) - 1;
    vec4 sum = vec4(0.0);
    float known = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 off = ivec2(i & 1, i >> 1);
        vec2 weights = mix(1.0 - share, share, vec2(off));
        ivec2 at = clamp(ivec2(corner) + off, ivec2(0), last);
        float weight = texelFetch(info, at, 0).r == infoUnknown ? 0.0 : weights.x * weights.y;
        sum += weight * texelFetch(color, at, 0);
        known += weight;
    }
    return sum / max(known, least);
}

// Of a reflection's colour and info. `texel` counts in those of mip 0, `scale` is how many pixels of the frame go to one, each way.
vec4 reflectionTexel(sampler2D color, sampler2D info, vec2 texel, float mip, float scale) {
    vec4 between = textureLod(color, texel / vec2(textureSize(color, 0)), scale > 1.0 ? max(mip, 1.0) : mip);
    if (scale > 1.0 && mip < 1.0) between = mix(knownBetween(color, info, texel), between, mip);
    return between;
}
