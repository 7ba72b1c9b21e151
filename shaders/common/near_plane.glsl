// Where lines of sight begin. Needs surface_uniforms.glsl.

// Of this pixel's, relative to the eye.
vec3 onNearPlane() {
    float nearDepth = depthSign > 0.0 ? 1.0 : 0.0;
    vec4 start = relativeFromPixel * vec4(gl_FragCoord.xy - vec2(region.xy), nearDepth, 1.0);
    return start.xyz / start.w;
}
