#include "reference/light/subsurface_scattering.h"

#include <algorithm>
#include <cmath>

#include "reference/light/air.h"
#include "reference/light/water_light.h"
#include "reference/shade/facet.h"
#include "reference/shade/optics.h"

namespace demos::reference {
namespace {

constexpr float g = 0.9185f; ///< of Henyey and Greenstein's phase function

float phase(float cosine) {
    return (1 - g * g) / (4 * pi) / std::pow(1 + g * g - 2 * g * cosine, 1.5f);
}

/// Less what it is where light turns by more than a level sea can hide: water_light.h has that.
float scattersForwards(float cosine) {
    return std::max(phase(cosine) - phase(0.125f), 0.0f);
}

/// By the phase function, around a unit vector (Henyey and Greenstein's inverted).
glm::vec3 turned(const glm::vec3& along, const glm::vec2& chance) {
    const float share = (1 - g * g) / (1 - g + 2 * g * chance.x);
    const float cosine = std::clamp((1 + g * g - share * share) / (2 * g), -1.0f, 1.0f);
    const float sine = std::sqrt(1 - cosine * cosine), turn = 2 * pi * chance.y;
    const glm::vec3 other = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(along, other));
    return glm::normalize(cosine * along +
                          sine * (std::cos(turn) * right + std::sin(turn) * glm::cross(along, right)));
}

/// From a point of a ray in the water to the surface.
struct Way {
    Ray ray;
    Hit hit;
    Facet facet; ///< at random, towards the water
};

bool wayOut(const Frame& frame, const glm::vec3& at, const glm::vec3& direction, Random& random, Way& out) {
    out.ray.origin = at;
    out.ray.direction = direction;
    out.ray.footprint = footprintAfter(at, direction, frame.apexM + frame.distanceTo(at), frame.pixelAngle);
    if (!frame.geometry.trace(out.ray, Kind::everything, out.hit)) return false;
    if (out.hit.kind != Kind::surface || out.hit.frontFacing) return false;
    out.facet = randomFacet(frame, out.ray, out.hit, 0.1f, random);
    return true;
}

glm::vec3 fromSky(const Frame& frame, const glm::vec3& at, const glm::vec3& along, const glm::vec3& behind,
                  Random& random) {
    Way way;
    const glm::vec3 direction = turned(along, random.next2());
    if (!wayOut(frame, at, direction, random, way)) return glm::vec3(0);
    const float fresnel = fresnelFromWater(-glm::dot(direction, way.facet.normal));
    if (fresnel >= 1) return glm::vec3(0);
    const glm::vec3 outward = glm::refract(direction, way.facet.normal, waterIndex);
    const float cosine = glm::dot(direction, along);
    const float counts = scattersForwards(cosine) / phase(cosine) * (1 - fresnel) * way.facet.weight;
    const glm::vec3 up = glm::normalize(glm::vec3(outward.x, std::abs(outward.y), outward.z));
    const glm::vec3 sky = skyThroughAir(frame, way.hit.position, up, frame.world->light.sky(up));
    return counts * glm::exp(-waterLightOf(frame).extinction() * way.hit.distance) * (sky - behind);
}

/// The beam that a facet bends to the point: found in two steps, the facet of one telling where the next is.
glm::vec3 fromSun(const Frame& frame, const glm::vec3& at, const glm::vec3& along, Random& random) {
    const Light& light = frame.world->light;
    if (light.toSun().y <= 0 || light.sunIrradiance() == glm::vec3(0)) return glm::vec3(0);
    const glm::vec3 toSun = light.towardsSun(random.next2());
    glm::vec3 normal(0, 1, 0), direction(0, 1, 0);
    Way way;
    for (int step = 0; step < 3; ++step) {
        if (glm::dot(normal, toSun) <= 0) return glm::vec3(0);
        direction = -glm::normalize(glm::refract(-toSun, normal, 1 / waterIndex));
        if (step == 2) break;
        if (!wayOut(frame, at, direction, random, way)) return glm::vec3(0);
        normal = -way.facet.normal;
    }
    const glm::vec3 up = -way.facet.up;
    if (frame.geometry.occluded(way.hit.position + up * clearanceAt(way.hit.position), toSun,
                                Kind::everything, way.ray.footprint))
        return glm::vec3(0);
    const float cosSun = glm::dot(normal, toSun);
    // Sunlight on the facet's share of the mesh, over what the beam is wide below it.
    const float widens =
        cosSun / std::max(normal.y, 0.1f) / std::max(glm::dot(direction, up) / std::max(up.y, 0.1f), 0.1f);
    const glm::vec3 left = glm::exp(-waterLightOf(frame).extinction() * way.hit.distance);
    return light.sunIrradiance() * left *
           (widens * (1 - fresnelWater(cosSun)) * scattersForwards(glm::dot(direction, along)) /
            (waterIndex * waterIndex));
}

} // namespace

glm::vec3 throughScattering(const Frame& frame, const Ray& ray, float path, const glm::vec3& behind,
                            float plume, Random random) {
    constexpr float byBubbles = 2; // where a wave has just broken [1/m]
    const auto byParticles = static_cast<float>(frame.world->water->refraction->scatteringPerM);
    const float scattering = byParticles + byBubbles * plume;
    if (byParticles == 0 || frame.surface.flat()) return behind;
    const glm::vec3 extinction = waterLightOf(frame).extinction();
    const float rate = std::min({extinction.x, extinction.y, extinction.z}) + 0.15f;
    const float t = -std::log(1 - random.next()) / rate;
    Hit out;
    if (t >= path || (frame.geometry.trace(ray, Kind::surface, out) && out.distance < t)) return behind;
    const glm::vec3 at = ray.origin + ray.direction * t;
    // Below that the sea is level to light: water_light.h has it.
    const double troughs = -seaglass::significantWaveHeight(*frame.world->sea) / 4;
    if (static_cast<double>(frame.heightOf(at)) < troughs) return behind;
    const glm::vec3 found =
        fromSky(frame, at, ray.direction, behind, random) + fromSun(frame, at, ray.direction, random);
    return behind + scattering / rate * glm::exp((rate - extinction) * t) * found;
}

} // namespace demos::reference
