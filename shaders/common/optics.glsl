// Light at the boundary of air and water.

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

// Density of Gaussian slopes with covariance (uu, vv, uv) at a distance `d` from their mean.
float slopeDensity(vec2 d, vec3 covariance) {
    float determinant = max(covariance.x * covariance.y - covariance.z * covariance.z, 1e-12);
    float exponent =
        (covariance.y * d.x * d.x - 2.0 * covariance.z * d.x * d.y + covariance.x * d.y * d.y) / determinant;
    return exp(-0.5 * exponent) / (2.0 * pi * sqrt(determinant));
}
