// The waves ahead of a point of the surface, which hide low sky, low sun and low things from it. Where they can be told apart
// they are looked for; beyond, and without `waveShadowSteps`, Smith's masking says how many rays get by.

layout(constant_id = 6) const int waveShadowSteps = 0;

struct WavesAhead {
    float horizon;   // tangent of the highest wave ahead
    float found;     // how far to go by it, 0..1: not where a pixel holds whole waves
    float unseen;    // deviation of the slopes of waves within the pixel
};

#ifdef WAVES
// The highest wave from here, by the slope, to nearly a length of the longest waves (100 deviations of height), at distances
// that grow evenly: what is nearer is finer. Heights are all of the maps: the mesh's differ by more than near waves rise.
float horizonTowards(vec2 slope, vec2 along) {
    const float nearest = 0.005;
    float growth = pow(nearest, -1.0 / float(waveShadowSteps - 1));
    float blur = 0.2 * (growth - 1.0);   // less than half a step, which would flatten the crests that cast shadows
    float away = nearest * 100.0 * within.z;
    vec3 here = waveDisplacementAt(waveDisplacement, calmPosition, blur * away, keptHere());
    vec2 moved = here.xz;
    float tangent = dot(slope, along);
    int i = 0;
    [[dont_unroll]] do {
        // What moved the last one stands for what moves this one.
        vec2 calm = calmPosition + here.xz + along * away - moved;
        vec3 there = waveDisplacementAt(waveDisplacement, calm, blur * away, keptHere());
        moved = there.xz;
        tangent = max(tangent, (there.y - here.y) / away);
        away *= growth;
    } while (++i < waveShadowSteps);
    return tangent;
}

WavesAhead wavesAhead(SurfacePoint s, vec2 along) {
    if (waveShadowSteps == 0) return WavesAhead(0.0, 0.0, 0.0);
    float unseen = 0.5 * (s.covariance.x + s.covariance.y);
    float found = clamp(3.0 - 3.0 * unseen / (roughness.w * roughness.w), 0.0, 1.0);
    float horizon = 0.0;
    if (found > 0.0) horizon = horizonTowards(s.slope, along);
    return WavesAhead(horizon, found, sqrt(unseen));
}

// Share of the rays of this rise that meet no other wave.
float clearShare(float rise, WavesAhead ahead) {
    if (rise <= 0.0) return 0.0;
    float masked = 1.0 / (1.0 + smithLambda(rise, roughness.w));
    if (waveShadowSteps == 0) return masked;
    const float soft = 0.005;   // the sun's disc, and as much for the sky: wider lets its glint into shadows
    float tangent = rise * inversesqrt(max(1.0 - rise * rise, 1e-4));
    float past = smoothstep(ahead.horizon - soft, ahead.horizon + soft, tangent) / (1.0 + smithLambda(rise, ahead.unseen));
    return mix(masked, past, ahead.found);
}
#endif
