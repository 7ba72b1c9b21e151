// Which pixels caustic_light.glsl takes for texels of light: water_functions_test.cpp.
#version 450
#extension GL_GOOGLE_include_directive : require

// In place of a body's.
#define BODY_GLSL
struct Water {
    ivec4 causticGrid;
};
Water water;
ivec2 regionSize() {
    return ivec2(64);
}
ivec2 sceneTexel(ivec2 pixel) {
    return pixel;
}
float pixelWidth(vec3 at) {
    return 1.0;
}
vec3 pointAt(vec2 pixel, float depth) {
    return vec3(pixel, depth);
}
bool isFarPlane(float depth) {
    return false;
}
float heightOverCalm(vec3 at) {
    return at.y;
}
#include "caustic_light.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Given {
    ivec4 texels[];   // and pixels from one to the next
};
layout(set = 0, binding = 1, std430) writeonly buffer Told {
    vec4 pixels[];
};

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= texels.length()) return;
    water.causticGrid = ivec4(texels[i].z, 0, 0, 0);
    pixels[i] = vec4(pixelOfTexel(texels[i].xy), 0.0, 0.0);
}
