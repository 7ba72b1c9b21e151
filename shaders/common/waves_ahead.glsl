// The waves ahead of a point of the surface, which hide low sky, low sun and low things from it. Where they can be told apart
// they are looked for; beyond, and without `waveShadowSteps`, Smith's masking says how many rays get by.

layout(constant_id = 6) const int waveShadowSteps = 0;

struct WavesAhead {
    float lower;      // share of the sea's heights below this one
    float horizon;    // tangent of the highest wave ahead
    float found;      // how far to go by it, 0..1
};

#ifdef WAVES
// The highest wave from here, by the slope, to nearly a length of the longest waves (100 deviations of height), at distances
// that grow evenly: what is nearer is finer.
float horizonTowards(vec2 slope, vec2 along, float height) {
    const float nearest = 0.005;
    float growth = pow(nearest, -1.0 / float(waveShadowSteps - 1));
    float away = nearest * 100.0 * within.z;
    vec2 moved = position.xz - calmPosition;
    float tangent = dot(slope, along);
    for (int i = 0; i < waveShadowSteps; ++i) {
        // What moved the last one stands for what moves this one.
        vec2 calm = position.xz + along * away - moved;
        vec3 there = waveDisplacementAt(waveDisplacement, calm, 0.5 * (growth - 1.0) * away, keptHere());
        moved = there.xz;
        tangent = max(tangent, (there.y - height) / away);
        away *= growth;
    }
    return tangent;
}

WavesAhead wavesAhead(SurfacePoint s, vec2 along) {
    float height = position.y + plane.w;
    // The normal distribution function, within 2e-4.
    float x = height / within.z;
    WavesAhead ahead = WavesAhead(1.0 / (1.0 + exp(-x * (1.5976 + 0.070565 * x * x))), 0.0, 0.0);
    if (waveShadowSteps > 0) {
        ahead.horizon = horizonTowards(s.slope, along, height);
        float unseen = 0.5 * (s.covariance.x + s.covariance.y) / (roughness.w * roughness.w);
        ahead.found = clamp(3.0 - 3.0 * unseen, 0.0, 1.0);
    }
    return ahead;
}

// Share of the rays of this rise that meet no other wave: Smith's masking by all the sea's slopes, which hides what lies
// in a trough before what stands on a crest (Bourlier, Berginc and Saillard 2002).
float clearShare(float rise, WavesAhead ahead) {
    if (rise <= 0.0) return 0.0;
    float masked = pow(ahead.lower, smithLambda(rise, roughness.w));
    if (waveShadowSteps == 0) return masked;
    const float soft = 0.015;
    float seen = smoothstep(ahead.horizon - soft, ahead.horizon + soft, rise * inversesqrt(max(1.0 - rise * rise, 1e-4)));
    return mix(masked, seen, ahead.found);
}
#endif
