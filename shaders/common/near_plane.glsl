// Where lines of sight begin. Needs surface_uniforms.glsl.

// Of this pixel's, relative to the eye.
vec3 onNearPlane() {
    float nearDepth = depthSign > 0.0 ? 1.0 : 0.0;
    vec4 start = relativeFromPixel * vec4(gl_FragCoord.xy - vec2(region.xy), nearDepth, 1.0);
    return start.xyz / start.w;
}

// How deep in the water the line of sight begins that leaves the near plane there: at the eye, if there is one [m].
float depthOfSight(vec3 start) {
    return max(-(plane.w + (1.0 - sight.w) * start.y), 0.0);
}
