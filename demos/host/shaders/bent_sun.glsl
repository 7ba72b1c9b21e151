// Under calm water the sun's rays are bent. Sheared along the surface by its depth, what lies there has them straight
// again, and one shadow map serves: what casts into it and what looks it up are moved alike.
#include "frame.glsl"

float depthInWater(vec3 fromEye) {
    return -dot(frame.waterPlane, vec4(fromEye, 1.0));
}

bool isSunBent(vec3 fromEye) {
    const vec4 p = vec4(fromEye, 1.0);
    return depthInWater(fromEye) > 0.0 && abs(dot(frame.waterAcross, p)) < 1.0 && abs(dot(frame.waterAlong, p)) < 1.0;
}

// How far a point is lit as what lies in water: 0 as deep as troughs are, since there it may stand out of it.
float shareInWater(vec3 fromEye) {
    if (!isSunBent(fromEye)) return 0.0;
    const float troughs = frame.sunShear.w;
    return troughs > 0.0 ? smoothstep(troughs, 1.6 * troughs, depthInWater(fromEye)) : 1.0;
}

vec3 sheared(vec3 fromEye) {
    return fromEye + depthInWater(fromEye) * frame.sunShear.xyz;
}

// Across a side with that unit normal once it is sheared. What lay a metre from that side then lies the inverse of its
// length from it.
vec3 shearedNormal(vec3 normal) {
    return normal + dot(frame.sunShear.xyz, normal) * frame.waterPlane.xyz;
}
