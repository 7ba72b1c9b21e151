// The least that a pass over a whole frame can cost: reads colour and depth once and writes them once.
#version 450

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform readonly image2D fromColor;
layout(set = 0, binding = 1, r32f) uniform readonly image2D fromDepth;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D toColor;
layout(set = 0, binding = 3, r32f) uniform writeonly image2D toDepth;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(toColor)))) return;
    imageStore(toColor, pixel, imageLoad(fromColor, pixel));
    imageStore(toDepth, pixel, imageLoad(fromDepth, pixel));
}
