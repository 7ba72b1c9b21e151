// Light at the boundary of air and water.
#ifndef OPTICS_GLSL
#define OPTICS_GLSL

const float pi = 3.14159265358979;
const float waterIndex = 1.333;

// Exact unpolarised dielectric reflectance from air into water (Born and Wolf 1999, 1.5.2).
float fresnelWater(float cosIncidence) {
    float c = clamp(cosIncidence, 0.0, 1.0);
    float g = sqrt(waterIndex * waterIndex - 1.0 + c * c);
    float a = (g - c) / (g + c);
    float b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

// The same by Schlick's approximation (1994).
float fresnelSchlick(float cosIncidence) {
    const float root = (waterIndex - 1.0) / (waterIndex + 1.0);
    const float straightOn = root * root;
    float d = 1.0 - clamp(cosIncidence, 0.0, 1.0);
    float d2 = d * d;
    return straightOn + (1.0 - straightOn) * (d2 * d2 * d);
}

// Density of slopes with covariance (uu, vv, uv) at a distance `d` from their mean. Of the variance the share `bounded` is of
// what ends somewhere, as the sun's disc does, and the rest Gaussian: (1 - q/(2(k + 2)))^k of the distance q in deviations
// squared, a disc for k = 0 and a Gaussian for endless k, has the kurtosis of the sum of both by k = 3/bounded^2 - 3.
float slopeDensity(vec2 d, vec3 covariance, float bounded) {
    float determinant = max(covariance.x * covariance.y - covariance.z * covariance.z, 1e-12);
    float q = (covariance.y * d.x * d.x - 2.0 * covariance.z * d.x * d.y + covariance.x * d.y * d.y) / determinant;
    float k = 3.0 / max(bounded * bounded, 0.01) - 3.0;
    float within = 1.0 - q / (2.0 * (k + 2.0));
    if (within <= 0.0) return 0.0;
    return (k + 1.0) / (k + 2.0) * pow(within, k) / (2.0 * pi * sqrt(determinant));
}

#endif
