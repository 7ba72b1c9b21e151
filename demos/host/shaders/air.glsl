// The fog between the eye and what it sees, by the function that the water has. `skyCube` is the includer's.
#include "frame.glsl"
#include "medium.glsl"

SeaglassFog fogHere() {
    return SeaglassFog(frame.fogColor, frame.fogForm, frame.fogReach);
}

int fogShape() {
    return int(frame.fogReach.z);
}

// What the fog adds before a point of the scene, if it were endless, and what share of light passes: of the way there that lies
// above the water. Another eye's positions, as of a mirrored one, are seen by the frame's own all the same.
vec4 airBefore(vec3 fromEye) {
    const vec3 at = fromEye - frame.fogEye.xyz, axis = frame.fogSight.xyz;
    const vec3 start = frame.fogSight.w > 0.0 ? vec3(0.0) : at - axis * (dot(at, axis) - frame.fogEye.w);
    const vec3 way = at - start;
    const float farness = length(way);
    const SeaglassFog fog = fogHere();
    vec3 color = fog.color.rgb;
    if (fog.color.w > 0.0) {
        const vec3 along = seaglass_fogSight(way / max(farness, 1e-6));
        color = seaglass_fogColor(fog, textureLod(skyCube, along, seaglass_fogMip(frame.sky.z + 1.0)).rgb);
    }
    const vec2 part = seaglass_partInAir(dot(frame.fogWater, vec4(start, 1.0)), dot(frame.fogWater, vec4(at, 1.0)));
    const float share = part.y - part.x;
    const float passes = seaglass_transmittance(fogShape(), fog, start.y + part.x * way.y, share * way.y, share * farness);
    return vec4(color, passes);
}

// Of what shines in the scene.
vec3 fogged(vec3 radiance, vec3 fromEye) {
    if (fogShape() == 0) return radiance;
    const vec4 air = airBefore(fromEye);
    return mix(air.rgb, radiance, air.a);
}

// The sky, from a height above the frame's eye.
vec3 foggedSky(vec3 sky, float above, vec3 direction) {
    if (fogShape() == 0 || frame.fogReach.w == 0.0) return sky;
    return seaglass_foggedSky(fogShape(), fogHere(), sky, above, direction);
}
