// Radiance of the sun's mirror image, spread by the slopes within the pixel (Bruneton, Neyret and Holzschuch 2010,
// eq. 14), the sun's own disc included in the variance.
vec3 sunGlint(SurfacePoint s, vec3 toEye) {
    const float discVariance = 5.4e-6;
    vec3 halfway = normalize(toEye + toSun.xyz);
    if (toSun.y <= 0.0 || halfway.y <= 0.0) return vec3(0.0);
    vec2 slope = -halfway.xz / halfway.y;
    float density = slopeDensity(slope - s.slope, s.covariance + vec3(discVariance, discVariance, 0.0));
    float fresnel = mirroredShare(dot(toEye, halfway));
    vec3 normal = normalOf(s.slope);
    float cosEye = max(dot(toEye, normal), 1e-3);
    float deviation = sqrt(0.5 * (s.covariance.x + s.covariance.y));
    float up2 = halfway.y * halfway.y;
    float masking = 1.0 + smithLambda(cosEye, deviation);
    float glint = sunSeen * fresnel * density / (4.0 * up2 * up2 * cosEye * masking);
#ifdef WAVES
    if (glint > 1e-5) {
        return sunIrradiance.rgb * (glint * clearShare(max(toSun.y, 1e-3), wavesAhead(s, horizontal(toSun.xyz))));
    }
#endif
    return sunIrradiance.rgb * glint;
}
