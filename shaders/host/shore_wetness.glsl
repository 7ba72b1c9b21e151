// How wet the waves of a shore keep the host's own sand, and what that does to it: seaglass/shore.h. The host declares before
// `vec4 seaglass_shoreRow(int row)`, which reads the buffer that it filled by shoreRows().

// seaglass::ShoreBlock.
struct SeaglassShore {
    vec4 place;
    vec4 rows;
    vec4 form;
};

const int seaglass_shoreTrains = 3;
const int seaglass_mostSamples = 128;

vec4 seaglass_shorePlace(SeaglassShore shore, sampler2D map, vec2 place) {
    ivec2 last = textureSize(map, 0) - 1;
    vec2 at = clamp(shore.place.xy + place * shore.place.z, vec2(0.0), vec2(last));
    ivec2 corner = min(ivec2(at), last - 1);
    vec2 share = at - vec2(corner);
    vec4 near = mix(texelFetch(map, corner, 0), texelFetch(map, corner + ivec2(1, 0), 0), share.x);
    vec4 far = mix(texelFetch(map, corner + ivec2(0, 1), 0), texelFetch(map, corner + ivec2(1, 1), 0), share.x);
    return mix(near, far, share.y);
}

// Of all trains, `rows` before now: up to where film has lain in a sample's time, and lies; the water's edge.
vec3 seaglass_shoreReach(SeaglassShore shore, vec4 here, float rows) {
    vec3 sum = vec3(0.0);
    int t = 0;
    do {
        float row = here[t] * shore.rows.x + shore.rows.y;
        row = (row > 0.0 ? row : 0.0) + rows;
        row = min(row, shore.rows.z - 1.001);
        int i = t * int(shore.rows.z) + int(row);
        sum += mix(seaglass_shoreRow(i).xyz, seaglass_shoreRow(i + 1).xyz, fract(row));
    } while (++t < seaglass_shoreTrains);
    return sum;
}

// At `place`, (u, v) from the eye, `height` over the calm plane [m]: how wet it is, 1 soaked; which share of it lies under water
// or a film of it, which Seaglass shades.
vec2 seaglass_wetness(SeaglassShore shore, sampler2D map, vec2 place, float height) {
    if (shore.rows.z <= 0.0) return vec2(0.0);
    vec4 here = seaglass_shorePlace(shore, map, place);
    float moves = here.w;
    // Close over the calm water sand draws it up.
    vec2 wet = vec2(1.0 - smoothstep(0.0, max(0.3 * moves, 1e-3), height), height < 0.0 ? 1.0 : 0.0);
    float wicks = 0.15 * moves;   // it climbs so far from where it stands [m]
    if (!(moves > 0.0) || height > moves * shore.form.w + wicks) return wet;
    vec3 now = moves * seaglass_shoreReach(shore, here, 0.0);
    float film = clamp((now.y - height) / max(0.8 * moves, 1e-3), 0.0, 1.0);
    wet.y = max(wet.y, max(smoothstep(0.0, 0.025, now.z - height), film));
    float reached = now.x;
    float left = 1.0;   // of the water that a sample's film brought
    int past = 0;
    do {
        wet.x = max(wet.x, left * smoothstep(-max(wicks, 1e-4), 0.0, reached - height));
        reached = moves * seaglass_shoreReach(shore, here, float(past + 1) * shore.rows.w).x;
        left = 1.0 - smoothstep(0.0, 1.0, float(past + 1) * shore.form.y / shore.form.z);
    } while (++past < min(int(shore.form.x), seaglass_mostSamples) && left > wet.x);
    return wet;
}

// The diffuse reflectance of what water soaks, sand say, by seaglass_wetness(). Grains scatter more forwards in water than in air,
// so that light goes deeper (Twomey et al. 1986; by the similarity of van de Hulst 1980). And the water's skin turns back part of
// what comes out (Angstrom 1925, Lekner and Dorf 1988), but under water, where that is Seaglass's to say.
vec3 seaglass_wetAlbedo(vec3 dry, vec2 wet) {
    const float forwards = 1.7;   // (1 - g) in air to that in water
    const float enters = 0.934, turnedBack = 0.475;   // of diffuse light
    vec3 s = (1.0 - dry) / (1.0 + 1.17 * dry);
    vec3 squared = forwards * s * s / (1.0 + (forwards - 1.0) * s * s);
    vec3 deeper = sqrt(squared);
    vec3 soaked = (1.0 - deeper) / (1.0 + 1.17 * deeper);
    vec3 comesOut = enters * (1.0 - turnedBack) / (1.0 - turnedBack * soaked);
    return mix(dry, soaked * mix(comesOut, vec3(1.0), wet.y), wet.x);
}

// Of its mirroring: water between the grains is smooth. Under water it is the water that mirrors.
float seaglass_wetRoughness(float dry, vec2 wet) {
    return mix(dry, min(dry, 0.35), wet.x * wet.x * (1.0 - wet.y));
}
