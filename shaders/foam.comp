// One step of the foam history: what the cascade's breakers left fades, and what breaks now is white
// (water/foam_history.h). A texel holds the step before and this one.
#version 450

layout(local_size_x = 8, local_size_y = 8) in;

struct Band {
    float threshold;     // Jacobian below which the cascade breaks
    float perJacobian;   // whiteness, for as much below
};

layout(set = 0, binding = 0, std140) uniform Foam {
    Band bands[4];
    float fade;
    float floor_;
    uint anew;   // nothing was there before
};
layout(set = 0, binding = 1) uniform sampler2DArray displacementMap;
layout(set = 0, binding = 2) uniform sampler2DArray derivativeMap;
layout(set = 0, binding = 3, rg16f) uniform image2DArray history;

void main() {
    uint samples = uint(imageSize(history).x);
    ivec3 at = ivec3(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y % samples, gl_GlobalInvocationID.y / samples);
    float shear = texelFetch(displacementMap, at, 0).w;
    vec2 stretch = 1.0 + texelFetch(derivativeMap, at, 0).zw;
    float jacobian = stretch.x * stretch.y - shear * shear;
    Band band = bands[at.z];
    float breaks = min((band.threshold - jacobian) * band.perJacobian, 1.0);
    float before = anew != 0u ? 0.0 : imageLoad(history, at).g;
    float faded = (before + floor_) * fade - floor_;
    imageStore(history, at, vec4(before, max(max(faded, breaks), 0.0), 0.0, 0.0));
}
