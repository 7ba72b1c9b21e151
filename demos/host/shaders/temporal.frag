// A frame, averaged with those before it where they showed the same (Karis 2014).
#version 460

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1) uniform sampler2D depth;
layout(set = 0, binding = 2) uniform sampler2D history;
layout(push_constant) uniform Constants {
    mat4 historyFromClip;
    vec2 pixel;   // as a share of the picture
    float kept;   // share of the history, 0 where there is none
    float moves;  // 0 where nothing has moved since
};
layout(location = 0) out vec4 outColor;

void main() {
    const ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(picture, 0) - 1;
    const vec3 now = texelFetch(picture, here, 0).rgb;
    vec3 low = now, high = now;
    // Edges move with what is in front.
    float nearest = 0.0;
    for (int i = 0; i < 9; ++i) {
        const ivec2 at = clamp(here + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        const vec3 light = texelFetch(picture, at, 0).rgb;
        low = min(low, light);
        high = max(high, light);
        nearest = max(nearest, texelFetch(depth, at, 0).r);
    }
    const vec2 at = gl_FragCoord.xy * pixel;
    const vec4 clip = historyFromClip * vec4(2.0 * at - 1.0, nearest, 1.0);
    const vec2 then = clip.w > 0.0 ? 0.5 * clip.xy / clip.w + 0.5 : vec2(-1.0);
    vec3 before = textureLod(history, then, 0.0).rgb;
    if (moves > 0.0) before = clamp(before, low, high);
    const bool seen = all(greaterThanEqual(then, vec2(0.0))) && all(lessThanEqual(then, vec2(1.0)));
    const bool broken = any(isnan(before)) || any(isinf(before));
    outColor = vec4(seen && kept > 0.0 && !broken ? mix(now, before, kept) : now, 1.0);
}
