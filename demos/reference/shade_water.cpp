#include "reference/shade_water.h"

#include <algorithm>
#include <cmath>

#include "reference/foam_pattern.h"
#include "reference/optics.h"
#include "reference/shade_opaque.h"

namespace demos::reference {
namespace {

constexpr float endless = 1e6f; ///< a path that meets no bed [m]

/// Width of the pixel on the calm surface around a hit [m].
float footprintOn(const Ray& ray, const Hit& hit) {
    const Spread spread = spreadOn(ray.footprint, hit.position, hit.facing());
    const float right = glm::length(glm::vec2(spread.right.x, spread.right.z));
    const float below = glm::length(glm::vec2(spread.below.x, spread.below.z));
    return std::max(right, below);
}

float travelledUntil(const Ray& ray, const Hit& hit) {
    return glm::length(ray.origin - ray.footprint.apex) + hit.distance;
}

/// One facet of the surface as a ray meets it.
struct Facet {
    WaterSurface::Slopes slopes;
    glm::vec3 normal{0, 1, 0};
    glm::vec3 up{0, 1, 0}; ///< of the mesh, towards the ray
    float meshCosine = 1;  ///< what the eye sees of a horizontal square metre of the mesh
    float weight = 1;
};

Facet meanFacet(const Frame& frame, const Ray& ray, const Hit& hit) {
    Facet f;
    f.up = hit.facing();
    f.slopes = frame.surface.slopes(frame.calmAt(hit), static_cast<double>(footprintOn(ray, hit)));
    f.normal = normalOf(f.slopes.mean);
    if (glm::dot(f.normal, ray.direction) > -1e-3f) f.normal = f.up;
    return f;
}

/// Two independent unit normals as slopes of this covariance: Cholesky's factor.
glm::vec2 correlated(const glm::vec3& covariance, const glm::vec2& normals) {
    const float u = std::sqrt(std::max(covariance.x, 1e-12f));
    const float mixed = covariance.z / u;
    return {u * normals.x,
            mixed * normals.x + std::sqrt(std::max(covariance.y - mixed * mixed, 0.0f)) * normals.y};
}

Facet randomFacet(const Frame& frame, const Ray& ray, const Hit& hit, float leastCosine, Random& random) {
    Facet f;
    f.up = hit.facing();
    f.slopes = frame.surface.slopes(frame.calmAt(hit), 0);
    const glm::vec2 slope = f.slopes.mean + correlated(frame.surface.roughness(), random.nextNormal());
    f.meshCosine = std::max(-glm::dot(ray.direction, f.up) / std::max(std::abs(f.up.y), 0.05f), leastCosine);
    const float seen = -glm::dot(ray.direction, glm::vec3(-slope.x, 1, -slope.y));
    // A trace is kept of facets seen from behind, so that no pixel's sum is empty.
    f.weight = std::clamp(seen / f.meshCosine, 1e-4f, 20.0f);
    f.normal = seen > 0 ? normalOf(slope) : f.up;
    return f;
}

/// Turns a ray that would go below the horizon up again, once no more bounces are followed.
glm::vec3 keptAbove(const glm::vec3& d) {
    return glm::normalize(glm::vec3(d.x, std::max(std::abs(d.y), 1e-3f), d.z));
}

Ray bentRay(const Frame& frame, const Ray& ray, const Hit& hit, const glm::vec3& side,
            const glm::vec3& direction) {
    Ray bent;
    bent.origin = hit.position + side * clearanceAt(hit.position);
    bent.direction = direction;
    bent.footprint = footprintAfter(bent.origin, direction, travelledUntil(ray, hit), frame.pixelAngle);
    return bent;
}

glm::vec3 mirrored(const Frame& frame, const Ray& ray, const Hit& hit, const Facet& facet, int bounces,
                   Random* random) {
    glm::vec3 direction = glm::normalize(glm::reflect(ray.direction, facet.normal));
    float kept = 1;
    const float above = glm::dot(direction, facet.up);
    if (above <= 0) { // into the mesh: a neighbouring facet mirrors it once more
        direction = glm::normalize(glm::reflect(direction, facet.up));
        kept = fresnelWater(-above);
    }
    if (bounces == 0) return kept * frame.world->light.sky(keptAbove(direction));
    return kept * radianceAlong(frame, bentRay(frame, ray, hit, facet.up, direction), bounces - 1, random);
}

/// waterGlow() of shaders/common/water_light.glsl: Morel and Prieur 1977.
glm::vec3 waterGlow(const Frame& frame, const glm::vec3& absorption, const glm::vec3& backscatter,
                    float path) {
    const Light& light = frame.world->light;
    const glm::vec3 a = glm::max(absorption, glm::vec3(1e-5f));
    const glm::vec3 reflectance = 0.33f * backscatter / (a + backscatter);
    const float sunUp = std::max(light.toSun().y, 0.0f);
    const float sunEnters = sunUp * (1 - fresnelWater(sunUp));
    constexpr float skyEnters = 0.934f; // 1 - 0.066, diffuse Fresnel reflectance of water
    const glm::vec3 down = light.sunIrradiance() * sunEnters + light.filtered.irradianceUp * skyEnters;
    constexpr float leaves = 0.98f / (waterIndex * waterIndex);
    return down / pi * reflectance * leaves * (1.0f - glm::exp(-2.0f * (a + backscatter) * path));
}

glm::vec3 refracted(const Frame& frame, const Ray& ray, const Hit& hit, const Facet& facet, Random* random) {
    const auto& desc = frame.world->water->refraction;
    if (!desc) return waterGlow(frame, glm::vec3(0), glm::vec3(0), endless);
    const glm::vec3 absorption(toGlm(desc->absorptionPerM)), backscatter(toGlm(desc->backscatterPerM));
    const glm::vec3 direction = glm::normalize(glm::refract(ray.direction, facet.normal, 1 / waterIndex));
    const Ray below = bentRay(frame, ray, hit, -facet.up, direction);
    Hit bed;
    if (!frame.geometry.trace(below, Kind::opaque, bed))
        return waterGlow(frame, absorption, backscatter, endless);
    const float path = glm::length(bed.position - hit.position);
    const float depth = std::max(-frame.heightOf(bed.position), 0.0f);
    const glm::vec3 through = glm::exp(-(absorption + backscatter) * (path + depth));
    return shadeHit(frame, below, bed, random) * through + waterGlow(frame, absorption, backscatter, path);
}

/// sunGlint() of shaders/common/sun_glint.glsl: Bruneton, Neyret and Holzschuch 2010, eq. 14.
glm::vec3 meanGlint(const Frame& frame, const Facet& facet, const glm::vec3& toEye) {
    constexpr float discVariance = 5.4e-6f;
    const Light& light = frame.world->light;
    const glm::vec3 toSun = light.toSun(), halfway = glm::normalize(toEye + toSun);
    if (toSun.y <= 0 || halfway.y <= 0) return glm::vec3(0);
    const glm::vec2 slope = -glm::vec2(halfway.x, halfway.z) / halfway.y;
    const glm::vec3& covariance = facet.slopes.covariance;
    const float density =
        slopeDensity(slope - facet.slopes.mean, covariance + glm::vec3(discVariance, discVariance, 0));
    const glm::vec3 normal = normalOf(facet.slopes.mean);
    const float cosEye = std::max(glm::dot(toEye, normal), 1e-3f);
    const float cosSun = std::max(glm::dot(toSun, normal), 1e-3f);
    const float deviation = std::sqrt(0.5f * (covariance.x + covariance.y));
    const float masking = 1 + smithLambda(cosEye, deviation) + smithLambda(cosSun, deviation);
    const float up2 = halfway.y * halfway.y;
    return light.sunIrradiance() *
           (fresnelWater(glm::dot(toEye, halfway)) * density / (4 * up2 * up2 * cosEye * masking));
}

/// Times the facet's weight. Of the facets around this one, distributed by what no map resolves, those that
/// mirror one point of the sun's disc.
glm::vec3 sampledGlint(const Frame& frame, const Facet& facet, const glm::vec3& toEye,
                       const glm::vec3& toSun) {
    const glm::vec3 halfway = glm::normalize(toEye + toSun);
    if (toSun.y <= 0 || halfway.y <= 0) return glm::vec3(0);
    const glm::vec2 slope = -glm::vec2(halfway.x, halfway.z) / halfway.y;
    const glm::vec3& rough = frame.surface.roughness();
    const glm::vec3 covariance(std::max(rough.x, 5.4e-6f), std::max(rough.y, 5.4e-6f), rough.z);
    const float density = slopeDensity(slope - facet.slopes.mean, covariance);
    const float up2 = halfway.y * halfway.y;
    return frame.world->light.sunIrradiance() *
           (fresnelWater(glm::dot(toEye, halfway)) * density / (4 * up2 * up2 * facet.meshCosine));
}

} // namespace

glm::vec3 shadeHit(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    const Light& light = frame.world->light;
    const glm::vec3 towardsSun = random ? light.towardsSun(random->next2()) : light.toSun();
    return shadeOpaque(frame.geometry, light, ray, hit, towardsSun);
}

MirroredRay mirrorOfMean(const Frame& frame, const Ray& ray, const Hit& hit) {
    const Facet facet = meanFacet(frame, ray, hit);
    const glm::vec3 direction = glm::normalize(glm::reflect(ray.direction, facet.normal));
    return {facet.normal, bentRay(frame, ray, hit, facet.up, direction)};
}

WaterRadiance shadeWater(const Frame& frame, const Ray& ray, const Hit& hit, int bounces, Random* random) {
    const World& world = *frame.world;
    const glm::vec3 toEye = -ray.direction;
    const float leastCosine = bounces == mostBounces ? 0.01f : 0.1f;
    const Facet facet =
        random ? randomFacet(frame, ray, hit, leastCosine, *random) : meanFacet(frame, ray, hit);
    const float fresnel = fresnelWater(glm::dot(toEye, facet.normal));
    glm::vec3 radiance = fresnel * mirrored(frame, ray, hit, facet, bounces, random) +
                         (1 - fresnel) * refracted(frame, ray, hit, facet, random);
    radiance *= facet.weight;

    // What mirrors the sun on flat water is the mirrored ray itself.
    const bool flat = frame.surface.flat();
    const glm::vec3 towardsSun = random ? world.light.towardsSun(random->next2()) : world.light.toSun();
    const bool sunUp = towardsSun.y > 0 && world.light.sunIrradiance() != glm::vec3(0);
    const bool lit = sunUp && !flat &&
                     !frame.geometry.occluded(hit.position + facet.up * clearanceAt(hit.position), towardsSun,
                                              random ? Kind::everything : Kind::opaque, ray.footprint);
    if (lit)
        radiance += random ? sampledGlint(frame, facet, toEye, towardsSun) : meanGlint(frame, facet, toEye);

    if (world.water->foam && !flat) {
        const auto samples = static_cast<float>(frame.desc.samples);
        const float footprint = footprintOn(ray, hit) / std::sqrt(samples);
        const glm::dvec2 calm = frame.calmAt(hit);
        const float cover = frame.surface.foamCover(calm, static_cast<double>(footprint));
        const glm::vec3 normal = normalOf(facet.slopes.mean);
        const float sun = lit ? std::max(glm::dot(normal, world.light.toSun()), 0.0f) : 0.0f;
        const glm::vec3 light = world.light.sunIrradiance() * sun + world.light.filtered.irradianceUp;
        const glm::vec3 foam = light * (static_cast<float>(world.water->foam->albedo) / pi * facet.weight);
        radiance = glm::mix(radiance, foam, foamMask(calm, footprint, cover));
    }
    return {radiance, facet.weight};
}

glm::vec3 radianceAlong(const Frame& frame, const Ray& ray, int bounces, Random* random) {
    const Light& light = frame.world->light;
    Hit hit;
    if (!frame.geometry.trace(ray, Kind::everything, hit)) {
        const glm::vec3 sky = light.sky(ray.direction);
        return frame.surface.flat() ? sky + light.sunDisc(ray.direction, 0.1f * static_cast<float>(sunRadius))
                                    : sky;
    }
    if (hit.kind == Kind::opaque) return shadeHit(frame, ray, hit, random);
    // Weights are 1 on the mean. What one sample of a bounce may count is bounded, or it would be seen as a
    // spark.
    const WaterRadiance water = shadeWater(frame, ray, hit, bounces, random);
    return water.radiance / std::max(water.weight, 1.0f);
}

} // namespace demos::reference
