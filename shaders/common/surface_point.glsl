// Slope of the surface at a pixel, and what of its waves is too small to be seen there: a Gaussian of slopes (Cox and Munk
// 1954), whose variance is what the mips of the derivatives lost plus what no cascade holds.

struct SurfacePoint {
    vec2 slope;        // mean over the pixel
    vec3 covariance;   // of the slopes within it: uu, vv, uv
    float slopeStep;   // change of slope to the next pixel
};

#ifdef WAVES
float jacobianOf(vec4 derivatives, float shear) {
    return (1.0 + derivatives.z) * (1.0 + derivatives.w) - shear * shear;
}
#endif

SurfacePoint surfacePoint() {
    SurfacePoint s = SurfacePoint(vec2(0.0), roughness.xyz, 0.0);
#ifdef WAVES
    vec4 derivatives = vec4(0.0);
    float shear = 0.0;
    vec3 variance = vec3(0.0);
    for (int i = 0; i < cascades; ++i) {
        vec3 at = vec3(cascade[i].xy + calmPosition * cascade[i].z, i);
        vec4 d = texture(waveDerivatives, at);
        vec4 moments = texture(waveMoments, at);
        derivatives += d;
        shear += moments.w;
        variance += moments.xyz - vec3(d.xy * d.xy, d.x * d.y);
    }
    variance.xy = max(variance.xy, 0.0);
    // Tangents (1 + dDx/du, dh/du, shear) and (shear, dh/dv, 1 + dDz/dv); their cross product is the normal.
    vec2 diagonal = 1.0 + derivatives.zw;
    vec2 bent = vec2(derivatives.x * diagonal.y - derivatives.y * shear, derivatives.y * diagonal.x - derivatives.x * shear);
    // Where the surface folds the Jacobian passes zero and the slope is vertical.
    s.slope = bent / max(jacobianOf(derivatives, shear), 0.15);
    s.covariance += variance;
    vec2 change = max(abs(dFdx(s.slope)), abs(dFdy(s.slope)));
    s.slopeStep = max(change.x, change.y);
#endif
    return s;
}

vec3 normalOf(vec2 slope) {
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}
