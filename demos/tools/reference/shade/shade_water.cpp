#include "reference/shade/shade_water.h"

#include <algorithm>
#include <cmath>

#include "reference/light/air.h"
#include "reference/light/foam_pattern.h"
#include "reference/light/subsurface_scattering.h"
#include "reference/light/water_light.h"
#include "reference/shade/facet.h"
#include "reference/shade/optics.h"
#include "reference/shade/shade_bed.h"
#include "reference/shade/shade_opaque.h"
#include "reference/shade/shade_water_below.h"
#include "reference/shade/wet_sand.h"

namespace demos::reference {
namespace {

constexpr float endless = 1e6f; ///< a path that meets no bed [m]

/// Turns a ray that would go below the horizon up again, once no more bounces are followed.
glm::vec3 keptAbove(const glm::vec3& d) {
    return glm::normalize(glm::vec3(d.x, std::max(std::abs(d.y), 1e-3f), d.z));
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
    if (bounces == 0) {
        const glm::mat3 level = frame.levelAt(hit.position);
        const glm::vec3 up = keptAbove(direction * level);
        return kept * skyThroughAir(frame, hit.position, up, frame.world->light.sky(up));
    }
    return kept * radianceAlong(frame, bentRay(ray, hit, facet.up, direction), bounces - 1, random);
}

glm::vec3 refracted(const Frame& frame, const Ray& ray, const Hit& hit, const Facet& facet, float plume,
                    Random* random) {
    const auto& desc = frame.world->water->refraction;
    const WaterLight light = waterLightOf(frame);
    if (!desc) return light.glow(endless);
    const glm::vec3 direction = glm::normalize(glm::refract(ray.direction, facet.normal, 1 / waterIndex));
    const Ray below = bentRay(ray, hit, -facet.up, direction);
    Hit bed;
    float path = endless;
    glm::vec3 radiance(0);
    if (frame.geometry.trace(below, Kind::opaque, bed)) {
        path = glm::length(bed.position - hit.position);
        // Leaving water, radiance is thinned as its cone widens: by n^2.
        const glm::vec3 through = glm::exp(-light.extinction() * path) / (waterIndex * waterIndex);
        radiance = shadeBed(frame, below, bed, random) * through;
    }
    radiance += light.glow(path);
    return random ? throughScattering(frame, below, path, radiance, plume, *random) : radiance;
}

// In what follows directions are in the axes of what is level there, as slopes are.

/// sunGlint() of shaders/water/surface/sun_glint.glsl: Bruneton, Neyret and Holzschuch 2010, eq. 14.
glm::vec3 meanGlint(const Frame& frame, const Facet& facet, const glm::vec3& toEye, const glm::vec3& toSun) {
    constexpr float discVariance = 5.4e-6f;
    const glm::vec3 halfway = glm::normalize(toEye + toSun);
    if (toSun.y <= 0 || halfway.y <= 0) return glm::vec3(0);
    const glm::vec2 slope = -glm::vec2(halfway.x, halfway.z) / halfway.y;
    const glm::vec3& covariance = facet.slopes.covariance;
    const float density =
        slopeDensity(slope - facet.slopes.mean, covariance + glm::vec3(discVariance, discVariance, 0));
    const glm::vec2& mean = facet.slopes.mean;
    const float clear = clearShareOf(slopesAlong(toSun, mean, covariance));
    const float area = visibleArea(slopesAlong(toEye, mean, covariance));
    const float up2 = halfway.y * halfway.y;
    return frame.world->light.sunIrradiance() *
           (clear * fresnelWater(glm::dot(toEye, halfway)) * density / (4 * up2 * up2 * area));
}

/// Times the facet's weight. Of the facets around this one, distributed by what no map resolves, those that
/// mirror one point of the sun's disc.
glm::vec3 sampledGlint(const Frame& frame, const Facet& facet, const glm::vec3& toEye,
                       const glm::vec3& toSun) {
    const glm::vec3 halfway = glm::normalize(toEye + toSun);
    if (toSun.y <= 0 || halfway.y <= 0) return glm::vec3(0);
    const glm::vec2 slope = -glm::vec2(halfway.x, halfway.z) / halfway.y;
    const glm::vec3& rough = facet.slopes.covariance;
    const glm::vec3 covariance(std::max(rough.x, 5.4e-6f), std::max(rough.y, 5.4e-6f), rough.z);
    const float density = slopeDensity(slope - facet.slopes.mean, covariance);
    const float up2 = halfway.y * halfway.y;
    return frame.world->light.sunIrradiance() *
           (fresnelWater(glm::dot(toEye, halfway)) * density / (4 * up2 * up2 * facet.meshCosine));
}

/// plumeGlow() of shaders/water/foam/foam_cover.glsl.
glm::vec3 plumeGlow(const Frame& frame, bool lit, float plume) {
    constexpr float reflects = 0.13f;
    const WaterLight light = waterLightOf(frame);
    return (lit ? light.entering : light.enteringFromSky) * (reflects / pi * plume) *
           glm::exp(-glm::mix(12.0f, 2.5f, plume) * light.extinction());
}

/// withFoam() of shaders/water/foam/foam_cover.glsl.
glm::vec3 withFoam(const glm::vec3& bare, const Frame& frame, const Facet& facet, const Foam& white,
                   const glm::vec3& toEye, const glm::vec3& toSun, const glm::vec3& mirror, float leaves,
                   bool lit) {
    constexpr float bumpiness = 0.7f, filmVariance = 0.12f, filmShare = 0.4f;
    constexpr float thinnest = 0.3f;
    Facet film = facet;
    film.slopes.mean += bumpiness * white.slope;
    film.slopes.covariance += glm::vec3(filmVariance, filmVariance, 0);
    const Light& light = frame.world->light;
    const glm::vec3 facing = normalOf(film.slopes.mean);
    const float sun = lit ? std::max(glm::dot(facing, toSun), 0.0f) : 0.0f;
    const float open = (0.5f + 0.5f * facing.y) * (1 + 0.4f * white.height);
    const glm::vec3 falls = light.sunIrradiance() * sun + light.filtered.irradianceUp * open;
    const glm::vec3 glint = lit ? meanGlint(frame, film, toEye, toSun) : glm::vec3(0);
    const glm::vec3 foamy = falls * (frame.world->water->foam->albedo / pi) + filmShare * (mirror + glint);
    glm::vec3 water = bare;
    if (frame.world->water->refraction) water += leaves * facet.weight * plumeGlow(frame, lit, white.plume);
    return glm::mix(water, foamy * facet.weight, white.mask * glm::mix(thinnest, 1.0f, white.fresh));
}

/// What is seen where the surface is not.
glm::vec3 dryUnder(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    Ray on = ray;
    on.nearest = hit.distance + clearanceAt(hit.position);
    Hit sand;
    return frame.geometry.trace(on, Kind::opaque, sand) ? shadeHit(frame, on, sand, random) : glm::vec3(0);
}

} // namespace

glm::vec3 shadeHit(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    const Light& light = frame.world->light;
    const glm::vec3 towardsSun = random ? light.towardsSun(random->next2()) : light.toSun();
    return shadeOpaque(frame.geometry, light, ray, hit, wetLookAt(frame, hit, ray.footprint), towardsSun);
}

MirroredRay mirrorOfMean(const Frame& frame, const Ray& ray, const Hit& hit) {
    const Facet facet = meanFacet(frame, ray, hit);
    const glm::vec3 direction = glm::normalize(glm::reflect(ray.direction, facet.normal));
    MirroredRay mean = {facet.normal, bentRay(ray, hit, facet.up, direction)};
    mean.ray.inWater = frame.world->water->underwater && !hit.frontFacing;
    return mean;
}

WaterRadiance shadeWater(const Frame& frame, const Ray& ray, const Hit& hit, int bounces, Random* random) {
    const World& world = *frame.world;
    if (world.water->underwater && !hit.frontFacing) return shadeWaterBelow(frame, ray, hit, bounces, random);
    const glm::mat3 level = frame.levelAt(hit.position);
    const glm::vec3 toEye = -ray.direction * level, toSun = world.light.toSun() * level;
    const float leastCosine = bounces == mostBounces ? 0.01f : 0.1f;
    const Facet facet =
        random ? randomFacet(frame, ray, hit, leastCosine, *random) : meanFacet(frame, ray, hit);
    const float fresnel = fresnelWater(-glm::dot(ray.direction, facet.normal));
    const glm::vec3 mirror = fresnel * mirrored(frame, ray, hit, facet, bounces, random);
    const bool flat = frame.surface.flat();
    Foam white;
    if (world.water->foam && !flat)
        white = foamAt(frame.surface, frame.calmAt(hit), foamWidth(ray, hit, random));
    glm::vec3 radiance = mirror + (1 - fresnel) * refracted(frame, ray, hit, facet, white.plume, random);
    radiance *= facet.weight;

    // What mirrors the sun on flat water is the mirrored ray itself.
    const glm::vec3 towardsSun = random ? world.light.towardsSun(random->next2()) : world.light.toSun();
    const bool sunUp = towardsSun.y > 0 && world.light.sunIrradiance() != glm::vec3(0);
    const bool lit = sunUp && !flat &&
                     !frame.geometry.occluded(hit.position + facet.up * clearanceAt(hit.position), towardsSun,
                                              random ? Kind::everything : Kind::opaque, ray.footprint);
    if (lit)
        radiance += random ? sampledGlint(frame, facet, toEye, towardsSun * level)
                           : meanGlint(frame, facet, toEye, toSun);

    if (world.water->foam && !flat)
        radiance = withFoam(radiance, frame, facet, white, toEye, toSun, mirror, 1 - fresnel, lit);
    const auto presence = static_cast<float>(
        frame.surface.edge(frame.calmAt(hit), static_cast<double>(footprintOn(ray, hit))).presence);
    if (presence < 1 && world.water->refraction)
        radiance = glm::mix(dryUnder(frame, ray, hit, random) * facet.weight, radiance, presence);
    return {radiance, facet.weight};
}

glm::vec3 radianceAlong(const Frame& frame, const Ray& ray, int bounces, Random* random) {
    const Light& light = frame.world->light;
    Hit hit;
    if (!frame.geometry.trace(ray, Kind::everything, hit)) {
        if (ray.inWater) return endlessWater(frame, ray);
        const glm::vec3 sky =
            skyThroughAir(frame, ray.origin, ray.direction, frame.skyFrom(ray.origin, ray.direction));
        return frame.surface.flat() ? sky + light.sunDisc(ray.direction, 0.1f * static_cast<float>(sunRadius))
                                    : sky;
    }
    if (hit.kind == Kind::opaque) {
        if (ray.inWater) return bedInWater(frame, ray, hit, random);
        return throughAir(frame, ray.origin, ray.direction, hit.distance, shadeHit(frame, ray, hit, random));
    }
    // Weights are 1 on the mean. What one sample of a bounce may count is bounded, or it would be seen as a
    // spark.
    const WaterRadiance water = shadeWater(frame, ray, hit, bounces, random);
    const glm::vec3 radiance = water.radiance / std::max(water.weight, 1.0f);
    return ray.inWater ? radiance
                       : throughAir(frame, ray.origin, ray.direction, hit.distance, radiance,
                                    std::min(water.weight, 1.0f));
}

} // namespace demos::reference
