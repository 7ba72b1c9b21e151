// What waves make of the sand, and of all else that is porous.
#include "frame.glsl"

layout(set = 0, binding = 5) uniform sampler2D shoreMap;
layout(set = 0, binding = 6, std430) readonly buffer ShoreRows {
    vec4 shoreRows[];
};

vec4 seaglass_shoreRow(int row) {
    return shoreRows[row];
}

#include "shore_wetness.glsl"

// As seaglass_wetness() has it; what is polished or painted takes no water up.
vec2 wetnessOf(vec3 fromEye, float roughness) {
    const SeaglassShore shore = SeaglassShore(frame.shorePlace, frame.shoreRows, frame.shoreForm);
    if (shore.rows.z <= 0.0) return vec2(0.0);
    const vec4 p = vec4(fromEye, 1.0);
    const vec2 wet = seaglass_wetness(shore, shoreMap, vec2(dot(frame.shoreU, p), dot(frame.shoreV, p)), dot(frame.shoreUp, p));
    return vec2(wet.x * smoothstep(0.5, 0.8, roughness), wet.y);
}
