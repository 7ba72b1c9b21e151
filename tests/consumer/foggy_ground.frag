// A host's own ground and smoke in the water's fog, by no shader of ours but what is installed for it: docs/surface.md.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(binding = 0) uniform samplerCube skyCube;

#include "medium.glsl"

layout(binding = 1, std140) uniform Air {
    SeaglassFog fog;   // seaglass::fogBlock()
    float skyMips;
} air;

layout(constant_id = 0) const int shape = seaglass_fogHeight;

layout(location = 0) in vec3 fromEye;
layout(location = 1) in vec4 smoke;   // premultiplied
layout(location = 0) out vec4 outColor;

void main() {
    const float way = length(fromEye);
    const vec3 sight = seaglass_fogSight(fromEye / way);
    const vec3 color = seaglass_fogColor(air.fog, textureLod(skyCube, sight, seaglass_fogMip(air.skyMips)).rgb);
    const vec4 m = seaglass_medium(shape, air.fog, color, 0.0, fromEye.y, way);
    const vec3 ground = vec3(0.2) * m.a + m.rgb;
    const vec4 before = vec4(smoke.rgb * m.a + smoke.a * m.rgb, smoke.a);
    const vec3 sky = seaglass_foggedSky(shape, air.fog, vec3(1.0), 0.0, sight);
    outColor = vec4(before.rgb + (1.0 - before.a) * (fromEye.y > 0.0 ? sky : ground), 1.0);
}
