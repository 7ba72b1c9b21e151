// One picture, blurred as it is made larger or smaller, over another by a share.
#version 460

layout(set = 0, binding = 0) uniform sampler2D source;
layout(push_constant) uniform Constants {
    vec2 pixel;   // of what is drawn to, as a share of it
    vec2 reach;   // of the taps, as a share of the source
    float share;
};
layout(location = 0) out vec4 outColor;

// What is broken stays where it is, and is seen there.
vec3 tap(vec2 at) {
    const vec3 light = textureLod(source, at, 0.0).rgb;
    return any(isnan(light)) || any(isinf(light)) ? vec3(0.0) : light;
}

void main() {
    const vec2 at = gl_FragCoord.xy * pixel;
    const vec3 light = tap(at - reach) + tap(at + reach) + tap(at + vec2(reach.x, -reach.y)) + tap(at + vec2(-reach.x, reach.y));
    outColor = vec4(0.25 * light, share);
}
