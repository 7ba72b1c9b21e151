// How far the waves move a point of the calm plane, as a mean over `width` metres. Needs surface.glsl.

#ifdef WAVES
// `kept` is a share of each cascade.
vec3 waveDisplacementAt(sampler2DArray displacements, vec2 calm, float width, vec4 kept) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < cascades; ++i) {
        float mip = max(log2(width * cascade[i].w), 0.0);
        // The last mip is the tile's mean, which is zero. A loop of one round, which CPU devices leave out.
        for (bool moves = mip < maxMip; moves; moves = false)
            sum += kept[i] * textureLod(displacements, vec3(cascade[i].xy + calm * cascade[i].z, i), mip).xyz;
    }
    return sum;
}
#endif
