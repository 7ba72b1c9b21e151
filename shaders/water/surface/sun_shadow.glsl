// How much of the sun the host's shadow map lets through to a point.
#ifndef SUN_SHADOW_GLSL
#define SUN_SHADOW_GLSL

#include "body.glsl"

layout(set = 0, binding = sunShadowMapBinding) uniform sampler2DArray sunShadowMap;

// Of the four texels around, those that are no nearer to the sun, as a linear tap weighs them (percentage-closer
// filtering: Reeves, Salesin and Cook 1987). What lies beyond the map's far end is as deep as that.
float shareLit(vec3 at, float layer, vec2 size) {
    vec2 corner = at.xy * size - 0.5;
    vec4 depths = textureGather(sunShadowMap, vec3((floor(corner) + 1.0) / size, layer));
    float sign = water.shadow.y;
    vec4 lit = step(sign * clamp(at.z, 0.0, 1.0), sign * depths);
    vec2 past = fract(corner);
    return mix(mix(lit.w, lit.z, past.x), mix(lit.x, lit.y, past.x), past.y);
}

float sunSeenAt(vec3 point) {
    vec2 size = vec2(textureSize(sunShadowMap, 0).xy);
    vec2 texel = 1.0 / size;   // within which a tap reaches into a neighbouring cascade
    int i = 0;
    bool inside;
    vec3 at;
    do {
        vec4 p = water.shadowFromRelative[i] * vec4(point, 1.0);
        at = p.xyz / p.w;
        vec4 bounds = water.shadowBounds[i];
        inside = all(greaterThan(at.xy, bounds.xy + texel)) && all(lessThan(at.xy, bounds.zw - texel));
    } while (!inside && ++i < int(water.shadow.x));
    return inside ? shareLit(at, water.shadowLayers[i], size) : 1.0;
}

#endif
