// Radiance of the sun's mirror image, spread by the slopes within the pixel (Bruneton, Neyret and Holzschuch 2010,
// eq. 14), the sun's own disc included in the variance; as a share of its irradiance, before what waves hide of it.
float sunGlint(SurfacePoint s, vec3 toEye) {
    const float discVariance = 5.4e-6;
    vec3 halfway = normalize(toEye + toSun.xyz);
    if (toSun.y <= 0.0 || halfway.y <= 0.0) return 0.0;
    vec2 slope = slopeOf(halfway);
    float density = slopeDensity(slope - s.slope, s.covariance + vec3(discVariance, discVariance, 0.0));
    float fresnel = mirroredShare(dot(toEye, halfway));
    float up2 = halfway.y * halfway.y;
    return sunSeen * fresnel * density / (4.0 * up2 * up2 * visibleArea(visibleSlopes(s, toEye), toEye));
}

#ifdef WAVES
WavesAhead wavesBeforeTheSun(SurfacePoint s) {
    return wavesAhead(s, horizontal(toSun.xyz), toSun.y / max(length(toSun.xz), 1e-6));
}

// From facets of this slope.
float sunClear(vec2 slope, WavesAhead ahead) {
    return clearShare(max(toSun.y, 1e-3), dot(slope, horizontal(toSun.xyz)), ahead);
}
#endif
