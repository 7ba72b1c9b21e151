#include "reference/light/water_light.h"

#include <algorithm>
#include <cmath>

#include "host/water/waves.h"

namespace demos::reference {

glm::vec3 WaterLight::scatteredIn(float depth, float rise, float path) const {
    glm::vec3 mean;
    for (int c = 0; c < 3; ++c) {
        const float x = extinction()[c] * (1 - rise) * path;
        mean[c] = x < 1e-3f ? 1 - 0.5f * x : (1 - std::exp(-x)) / x;
    }
    return 2.0f * extinction() * deep() * glm::exp(-extinction() * depth) * path * mean;
}

WaterLight waterLightOf(const Frame& frame) {
    const Light& light = frame.world->light;
    WaterLight water;
    if (const auto& desc = frame.world->water->refraction) {
        const seaglass::WaterCoefficients given = coefficientsOf(*desc);
        for (int c = 0; c < 3; ++c) {
            water.absorption[c] = std::max(given.absorption[c], 1e-5f);
            water.backscatter[c] = given.backscatter[c];
        }
    }
    const float sunUp = std::max(light.toSun().y, 0.0f);
    const float sunEnters = sunUp * (1 - fresnelWater(sunUp));
    constexpr float skyEnters = 0.934f; // 1 - 0.066, diffuse Fresnel reflectance of water
    water.enteringFromSky = light.filtered.irradianceUp * skyEnters;
    water.entering = light.sunIrradiance() * sunEnters + water.enteringFromSky;
    return water;
}

bool isInWater(const Frame& frame, const glm::vec3& position) {
    const auto& water = frame.world->water;
    if (!water || !water->underwater) return false;
    if (isExcluded(frame.excludedVolumes, frame.camera.eye + glm::dvec3(position))) return false;
    Ray up;
    up.origin = position;
    up.direction = {0, 1, 0};
    Hit hit;
    return frame.geometry.trace(up, Kind::surface, hit);
}

namespace {

float depthAt(const Frame& frame, const glm::vec3& position) {
    return std::max(-frame.heightOf(position), 0.0f);
}

glm::vec3 scatteredIn(const Frame& frame, const Ray& ray, float length) {
    const glm::vec3 start = ray.origin + ray.direction * ray.nearest;
    return waterLightOf(frame).scatteredIn(depthAt(frame, start), ray.direction.y, length);
}

} // namespace

glm::vec3 throughWater(const Frame& frame, const Ray& ray, float length, const glm::vec3& radiance) {
    return radiance * glm::exp(-waterLightOf(frame).extinction() * length) + scatteredIn(frame, ray, length);
}

glm::vec3 endlessWater(const Frame& frame, const Ray& ray) {
    // Upwards the surface is met first, but where its mesh ends.
    constexpr float endless = 1e6f;
    const glm::vec3 start = ray.origin + ray.direction * ray.nearest;
    const float toSurface = depthAt(frame, start) / std::max(ray.direction.y, 1e-9f);
    return scatteredIn(frame, ray, ray.direction.y > 0 ? std::min(toSurface, endless) : endless);
}

} // namespace demos::reference
