#include "reference/shade_bed.h"

#include <algorithm>

#include "reference/shade_opaque.h"
#include "reference/water_light.h"

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
bool inShadow(const Frame& frame, const Bed& bed, const glm::vec3& inWater, const glm::vec3& inAir,
              const Footprint& footprint) {
    const float path = bed.depth / inWater.y;
    return frame.geometry.occluded(bed.at, inWater, Kind::opaque, footprint, path) ||
           frame.geometry.occluded(bed.at + inWater * path, inAir, Kind::opaque, footprint);
}

} // namespace

glm::vec3 shadeBed(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    const Light& light = frame.world->light;
    const MeshMaterial& material = hit.part->model->mesh.materials[hit.part->materials[hit.triangle]];
    const Bed bed = {hit.position + hit.facing() * clearanceAt(hit.position), normalAt(hit),
                     std::max(-frame.heightOf(hit.position), 0.0f), waterLightOf(frame).extinction()};
    const glm::vec3 toSun = light.toSun();
    const Beam sun = enteringBeam(toSun, light.sunIrradiance() * std::max(toSun.y, 0.0f));
    glm::vec3 irradiance = received(bed, sun);
    if (irradiance != glm::vec3(0)) {
        const glm::vec3 inAir = random ? light.towardsSun(random->next2()) : toSun;
        if (inShadow(frame, bed, enteringBeam(inAir, glm::vec3(0)).from, inAir, ray.footprint))
            irradiance = glm::vec3(0);
    }
    for (const Beam& beam : frame.sky) irradiance += received(bed, beam);

    const glm::vec3 albedo(baseColorAt(*hit.part, hit.triangle, hit.weights, hit.position, ray.footprint));
    // Of diffuse light 0.066 is turned back from above, and so 1 - 0.934 / n^2 from below.
    constexpr float turnedBack = 1 - 0.934f / (waterIndex * waterIndex);
    // Flatter than the critical angle light goes 3 m a metre of depth in the mean, up and down.
    const glm::vec3 again = turnedBack * albedo * glm::exp(-6 * bed.depth * bed.extinction);
    return material.emissive + albedo / pi * irradiance / (1.0f - again);
}

glm::vec3 bedInWater(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    return throughWater(frame, ray, std::max(hit.distance - ray.nearest, 0.0f),
                        shadeBed(frame, ray, hit, random));
}

} // namespace demos::reference
