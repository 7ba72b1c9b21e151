// How much of the sun the host's shadow map lets through to a point. Needs surface_uniforms.glsl and SUN_SHADOW_BINDING.

layout(set = 0, binding = SUN_SHADOW_BINDING) uniform sampler2DArray sunShadowMap;

// Of the four texels around, those that are no nearer to the sun, as a linear look weighs them (percentage-closer
// filtering: Reeves, Salesin and Cook 1987). What lies beyond the map's far end is as deep as that.
float shareLit(vec3 at, float layer, vec2 size) {
    vec2 corner = at.xy * size - 0.5;
    vec4 depths = textureGather(sunShadowMap, vec3((floor(corner) + 1.0) / size, layer));
    float sign = stored.shadow.y;
    vec4 lit = step(sign * clamp(at.z, 0.0, 1.0), sign * depths);
    vec2 past = fract(corner);
    return mix(mix(lit.w, lit.z, past.x), mix(lit.x, lit.y, past.x), past.y);
}

// A quarter of a pixel's side on the map, or half a texel where that is more.
vec2 quarter(mat4 textureFromRelative, vec3 side, vec2 size) {
    vec2 step = 0.25 * (textureFromRelative * vec4(side, 0.0)).xy;
    return step * max(0.5 / max(length(step * size), 1e-6), 1.0);
}

// A mean over the pixel, which may be far larger than a texel. `right` and `below` lead to the next ones.
float sunSeenFrom(vec3 point, vec3 right, vec3 below) {
    vec2 size = vec2(textureSize(sunShadowMap, 0).xy);
    vec2 texel = 1.0 / size;   // within which a look reaches into a neighbouring cascade
    for (int i = 0; i < int(stored.shadow.x); ++i) {
        mat4 textureFromRelative = stored.shadowFromRelative[i];
        vec4 p = textureFromRelative * vec4(point, 1.0);
        vec3 at = p.xyz / p.w;
        vec4 bounds = stored.shadowBounds[i];
        vec2 u = quarter(textureFromRelative, right, size), v = quarter(textureFromRelative, below, size);
        vec2 reach = abs(u) + abs(v) + texel;
        // Steps to the sky are not finite: nothing holds them.
        if (!(all(greaterThan(at.xy, bounds.xy + reach)) && all(lessThan(at.xy, bounds.zw - reach)))) continue;
        float sum = 0.0;
        for (int j = 0; j < 4; ++j) {
            vec2 offset = ((j & 1) == 0 ? u : -u) + ((j & 2) == 0 ? v : -v);
            sum += shareLit(vec3(at.xy + offset, at.z), stored.shadowLayers[i], size);
        }
        return 0.25 * sum;
    }
    return 1.0;
}
