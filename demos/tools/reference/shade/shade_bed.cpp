#include "reference/shade/shade_bed.h"

#include <algorithm>

#include "reference/light/water_light.h"
#include "reference/shade/shade_opaque.h"
#include "reference/shade/wet_sand.h"

namespace demos::reference {
namespace {

struct Bed {
    glm::vec3 at{0}; ///< a little off it
    glm::vec3 normal{0, 1, 0};
    float depth = 0;
    glm::vec3 extinction{0};
};

/// Irradiance that a beam leaves, nothing in its way.
glm::vec3 received(const Bed& bed, const Beam& beam) {
    const float facing = std::max(glm::dot(bed.normal, beam.from), 0.0f);
    return beam.irradiance * facing * glm::exp(-bed.extinction * (bed.depth / beam.from.y));
}

/// Both in the water and from there to the sun.
bool inShadow(const Frame& frame, const Bed& bed, const Footprint& footprint, Random* random) {
    const Light& light = frame.world->light;
    const glm::vec3 inAir = random ? light.towardsSun(random->next2()) : light.toSun();
    const glm::vec3 inWater = enteringBeam(inAir, glm::vec3(0)).from;
    const float path = bed.depth / inWater.y;
    return frame.geometry.occluded(bed.at, inWater, Kind::opaque, footprint, path) ||
           frame.geometry.occluded(bed.at + inWater * path, inAir, Kind::opaque, footprint);
}

/// Shares of a beam of the sun.
struct Sunlit {
    float evenly = 0;   ///< were the water calm
    glm::vec3 truly{0}; ///< as waves gather it, but for what has been scattered and knows of waves no more
};

Sunlit sunlitOf(const Frame& frame, const Bed& bed, const Hit& hit, const glm::vec3& from,
                const Footprint& footprint, Random* random) {
    const float evenly = inShadow(frame, bed, footprint, random) ? 0.0f : 1.0f;
    const std::optional<float> gain = frame.caustics.gainAt(frame, hit.position, hit.geometricNormal, from);
    if (!gain) return {evenly, glm::vec3(evenly)};
    const glm::vec3 straight = glm::exp(-waterLightOf(frame).scattering() * (bed.depth / from.y));
    return {evenly, glm::mix(glm::vec3(evenly), glm::vec3(*gain), straight)};
}

} // namespace

glm::vec3 shadeBed(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    const Light& light = frame.world->light;
    const Look look = wetLookAt(frame, hit, ray.footprint);
    if (look.unlit) return look.emissive;
    const glm::vec3 normal = mappedNormal(hit, normalAt(hit), ray.footprint);
    const Bed bed = {lightLeavesFrom(hit), normal, std::max(-frame.heightOf(hit.position), 0.0f),
                     waterLightOf(frame).extinction()};
    const glm::vec3 toSun = light.toSun();
    const Beam sun = enteringBeam(toSun, light.sunIrradiance() * std::max(toSun.y, 0.0f));
    glm::vec3 irradiance = received(bed, sun), around = irradiance;
    if (irradiance != glm::vec3(0)) {
        const Sunlit sunlit = sunlitOf(frame, bed, hit, sun.from, ray.footprint, random);
        irradiance *= sunlit.truly;
        around *= sunlit.evenly;
    }
    for (const Beam& beam : frame.sky) {
        const glm::vec3 sky = look.open * received(bed, beam);
        irradiance += sky;
        around += sky;
    }

    const glm::vec3 albedo = look.base;
    // Of diffuse light 0.066 is turned back from above, and so 1 - 0.934 / n^2 from below.
    constexpr float turnedBack = 1 - 0.934f / (waterIndex * waterIndex);
    // Flatter than the critical angle light goes 3 m a metre of depth in the mean, up and down.
    const glm::vec3 again = turnedBack * albedo * glm::exp(-6 * bed.depth * bed.extinction);
    return look.emissive + albedo / pi * (irradiance - around + around / (1.0f - again));
}

glm::vec3 bedInWater(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    return throughWater(frame, ray, std::max(hit.distance - ray.nearest, 0.0f),
                        shadeBed(frame, ray, hit, random));
}

} // namespace demos::reference
