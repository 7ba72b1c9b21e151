// Where the near plane of a view that stands in both leaves the water. Needs surface_uniforms.glsl.

#ifdef WAVES
vec3 displacementOf(vec2 calm) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < stored.cascades; ++i) {
        float mip = max(log2(within.x * cascade[i].w), 0.0);   // as the finest cells of the mesh have it
        if (mip < maxMip) sum += textureLod(waveDisplacement, vec3(cascade[i].xy + calm * cascade[i].z, i), mip).xyz;
    }
    return sum;
}
#endif

// Of a point above the displaced surface [m]; waves move points sideways too, so what is above it is looked for.
float heightAboveSurface(vec3 at) {
    float height = at.y + plane.w;
#ifdef WAVES
    vec2 calm = at.xz;
    for (int i = 0; i < 3; ++i) calm = at.xz - displacementOf(calm).xz;
    height -= displacementOf(calm).y;
#endif
    return height;
}
