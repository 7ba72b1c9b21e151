// What a sky's picture has not: edges of clouds that are finer than its texels. Noise moves the place that is looked up, by waves
// of some texels and less, as far as a pixel shows them. It needs no memory, leaves even sky as it is, and keeps the mean.

vec3 hashOf(ivec3 cell) {
    uint bits = uint(cell.x) * 0x9e3779b9u ^ uint(cell.y) * 0x85ebca6bu ^ uint(cell.z) * 0xc2b2ae35u;
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    bits ^= bits >> 16;
    return vec3(uvec3(bits, bits >> 11, bits >> 22) & uvec3(2047u, 2047u, 1023u)) * (2.0 / vec3(2047.0, 2047.0, 1023.0)) - 1.0;
}

vec3 noiseAt(vec3 at) {
    const vec3 whole = floor(at);
    const ivec3 cell = ivec3(whole);
    vec3 past = at - whole;
    past *= past * (3.0 - 2.0 * past);
    vec3 layers[2];
    for (int z = 0; z < 2; ++z) {
        const vec3 near = mix(hashOf(cell + ivec3(0, 0, z)), hashOf(cell + ivec3(1, 0, z)), past.x);
        const vec3 far = mix(hashOf(cell + ivec3(0, 1, z)), hashOf(cell + ivec3(1, 1, z)), past.x);
        layers[z] = mix(near, far, past.y);
    }
    return mix(layers[0], layers[1], past.z);
}

// A direction near `d`. `texel` and `pixel`: how wide they are [rad]. `share`: 0 none, 1 as ragged as cumulus is.
vec3 raggedSky(vec3 d, float texel, float pixel, float share) {
    const int octaves = 4;
    vec3 moved = vec3(0.0);
    float wave = 3.0 * texel, far = 1.1 * share * texel;
    int octave = 0;
    do {
        const float shows = smoothstep(2.0, 4.0, wave / pixel);
        if (shows <= 0.0) break;
        moved += far * shows * noiseAt(d / wave);
        wave *= 0.5;
        far *= 0.62;
    } while (++octave < octaves);
    // Towards the horizon layers of cloud are seen edge on.
    moved.y *= mix(0.35, 1.0, smoothstep(0.0, 0.3, d.y));
    return moved == vec3(0.0) ? d : normalize(d + moved);
}
