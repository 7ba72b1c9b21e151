#version 460

// As demos/host/passes/tonemap.cpp and demos/tools/program/compare/visualise.cpp make them on the CPU.

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(push_constant) uniform Constants {
    uint tone;
    float scale;
};
layout(location = 0) out vec4 outColor;

const uint light = 0, asIs = 1, grey = 2, signedGrey = 3, direction = 4;

vec3 agxCurve(vec3 x) {
    const vec3 x2 = x * x, x4 = x2 * x2;
    return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

/// Display-encoded, 0..1, from linear sRGB.
vec3 agx(vec3 linear) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992,
                            0.878468636469772, 0.0784336, 0.0792237451477643, 0.0791661274605434,
                            0.879142973793104);
    const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438, -0.0980208811401368,
                             1.15190312990417, -0.0980434501171241, -0.0990297440797205, -0.0989611768448433,
                             1.15107367264116);
    const float minEv = -12.47393, maxEv = 4.026069;
    const vec3 ev = log2(max(inset * linear, vec3(1e-10)));
    const vec3 curve = agxCurve(clamp((ev - minEv) / (maxEv - minEv), 0.0, 1.0));
    const vec3 contrasted = pow(max(curve, vec3(0.0)), vec3(1.2));
    const float luma = dot(contrasted, vec3(0.2126, 0.7152, 0.0722));
    const vec3 coloured = max(mix(vec3(luma), contrasted, 1.25), vec3(0.0));
    return clamp(outset * coloured, 0.0, 1.0);
}

/// AgX is made for a display with a pure 2.2 curve; bytes are sRGB.
vec3 encodeSrgb(vec3 display) {
    const vec3 linear = pow(display, vec3(2.2));
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear,
               lessThanEqual(linear, vec3(0.0031308)));
}

vec3 toned(vec3 value) {
    if (any(isnan(value)) || any(isinf(value))) return vec3(1.0, 0.0, 1.0);
    return encodeSrgb(agx(max(value * scale, vec3(0.0))));
}

void main() {
    const vec3 value = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 color = value;
    if (tone == light) color = toned(value);
    if (tone == grey) color = value.rrr;
    if (tone == signedGrey) color = vec3(0.5 + 0.5 * value.r / scale);
    if (tone == direction) color = value == vec3(0.0) ? vec3(0.0) : 0.5 + 0.5 * value;
    outColor = vec4(color, 1.0);
}
