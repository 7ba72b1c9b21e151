// What one sample of each pixel is to hold.
#version 450

layout(set = 0, binding = 0) uniform sampler2D colors;
layout(set = 0, binding = 1) uniform sampler2D depths;
layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = texelFetch(colors, pixel, 0);
    gl_FragDepth = texelFetch(depths, pixel, 0).r;
}
