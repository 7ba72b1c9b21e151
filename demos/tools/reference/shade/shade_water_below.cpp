#include "reference/shade/shade_water_below.h"

#include <algorithm>
#include <cmath>

#include "reference/light/air.h"
#include "reference/light/foam_pattern.h"
#include "reference/light/water_light.h"
#include "reference/shade/facet.h"
#include "reference/shade/optics.h"

namespace demos::reference {
namespace {

/// Refraction gathers light into the window: radiance grows by n^2.
constexpr float gathered = waterIndex * waterIndex;

/// Keeps a ray on the side of the mesh that `side` points to.
glm::vec3 keptOn(const glm::vec3& side, const glm::vec3& direction) {
    const float along = glm::dot(direction, side);
    return along > 0 ? direction : glm::normalize(direction - (2 * along) * side);
}

glm::vec3 mirroredDown(const Frame& frame, const Ray& ray, const Hit& hit, const Facet& facet, int bounces,
                       Random* random) {
    const glm::vec3 direction = keptOn(facet.up, glm::normalize(glm::reflect(ray.direction, facet.normal)));
    Ray down = bentRay(ray, hit, facet.up, direction);
    down.inWater = true;
    return bounces == 0 ? endlessWater(frame, down) : radianceAlong(frame, down, bounces - 1, random);
}

glm::vec3 aboveWater(const Frame& frame, const Ray& ray, const Hit& hit, const Facet& facet, int bounces,
                     Random* random) {
    const glm::vec3 direction =
        keptOn(-facet.up, glm::normalize(glm::refract(ray.direction, facet.normal, waterIndex)));
    const Ray out = bentRay(ray, hit, -facet.up, direction);
    if (bounces > 0) return radianceAlong(frame, out, bounces - 1, random);
    return skyThroughAir(frame, out.origin, direction, frame.world->light.sky(direction));
}

/// sunThrough() of shaders/water/surface/surface_below.glsl, of slopes with this mean and covariance: Walter
/// et al. 2007.
glm::vec3 sunThrough(const Frame& frame, const glm::vec2& mean, const glm::vec3& covariance,
                     const glm::vec3& toEye, const glm::vec3& toSun, float seen) {
    glm::vec3 halfway = -(toSun + waterIndex * toEye);
    if (toSun.y <= 0 || halfway.y <= 0) return glm::vec3(0);
    const float gap = glm::length(halfway);
    halfway /= gap;
    const float cosSun = glm::dot(toSun, halfway), cosEye = -glm::dot(toEye, halfway);
    if (cosSun <= 0 || cosEye <= 0) return glm::vec3(0);
    const float disc = 5.4e-6f / (gap * gap);
    const glm::vec2 slope = -glm::vec2(halfway.x, halfway.z) / halfway.y;
    const float density = slopeDensity(slope - mean, covariance + glm::vec3(disc, disc, 0));
    const float up2 = halfway.y * halfway.y;
    return frame.world->light.sunIrradiance() * (cosSun * cosEye * gathered * (1 - fresnelWater(cosSun)) *
                                                 density / (up2 * up2 * seen * gap * gap));
}

} // namespace

WaterRadiance shadeWaterBelow(const Frame& frame, const Ray& ray, const Hit& hit, int bounces,
                              Random* random) {
    const World& world = *frame.world;
    const float leastCosine = bounces == mostBounces ? 0.01f : 0.1f;
    const Facet facet =
        random ? randomFacet(frame, ray, hit, leastCosine, *random) : meanFacet(frame, ray, hit);
    const float fresnel = fresnelFromWater(-glm::dot(ray.direction, facet.normal));
    glm::vec3 radiance = fresnel * mirroredDown(frame, ray, hit, facet, bounces, random);
    if (fresnel < 1)
        radiance += (1 - fresnel) * gathered * aboveWater(frame, ray, hit, facet, bounces, random);

    radiance *= facet.weight;

    // Through flat water the refracted ray itself meets the sun.
    const bool flat = frame.surface.flat();
    const bool lit = !flat && world.light.toSun().y > 0 &&
                     !frame.geometry.occluded(hit.position - facet.up * clearanceAt(hit.position),
                                              world.light.toSun(), Kind::opaque, ray.footprint);
    if (lit) {
        const glm::vec3 covariance = random ? frame.surface.roughness() : facet.slopes.covariance;
        const float seen = random ? facet.meshCosine
                                  : visibleArea(slopesAlong(ray.direction, facet.slopes.mean, covariance));
        radiance +=
            sunThrough(frame, facet.slopes.mean, covariance, -ray.direction, world.light.toSun(), seen);
    }
    if (world.water->foam && !flat) {
        const Foam white = foamAt(frame.surface, frame.calmAt(hit), foamWidth(ray, hit, random));
        const glm::vec3 foam =
            waterLightOf(frame).entering * ((1 - world.water->foam->albedo) / pi * facet.weight);
        radiance = glm::mix(radiance, foam, white.mask);
    }
    const float path = std::max(hit.distance - ray.nearest, 0.0f);
    return {throughWater(frame, ray, path, radiance / facet.weight) * facet.weight, facet.weight};
}

} // namespace demos::reference
