#include "reference/shade/shade_floor.h"

#include <algorithm>
#include <cmath>

#include "reference/light/air.h"
#include "reference/shade/ggx.h"
#include "reference/shade/shade_water.h"

namespace demos::reference {
namespace {

float schlick(float f0, float cosine) {
    return f0 + (1 - f0) * std::pow(1 - cosine, 5.0f);
}

/// As fresnel() of demos/host/shaders/mirror.frag.
float coatFresnel(const FloorDesc& floor, float cosine) {
    const auto f0 = static_cast<float>(floor.reflectance), roughness = static_cast<float>(floor.roughness);
    const float facing = std::min(std::sqrt(cosine * cosine + 0.25f * std::pow(roughness, 1.66f)), 1.0f);
    return schlick(f0, facing) / (1 + 1.3f * roughness * roughness * roughness);
}

Ray mirroredRay(const Ray& ray, const Hit& hit, const glm::vec3& facet) {
    Ray mirrored;
    mirrored.origin = hit.position + hit.facing() * clearanceAt(hit.position);
    mirrored.direction = glm::normalize(glm::reflect(ray.direction, facet));
    const float travelled = glm::length(ray.origin - ray.footprint.apex) + hit.distance;
    mirrored.footprint = footprintAfter(mirrored.origin, mirrored.direction, travelled, ray.footprint.angle);
    return mirrored;
}

/// A floor is flat, and never sees itself.
glm::vec3 radianceOf(const Frame& frame, const Ray& mirrored, bool withSun, Random* random) {
    Hit hit;
    if (frame.geometry.trace(mirrored, Kind::opaque, hit))
        return throughAir(frame, mirrored.origin, mirrored.direction, hit.distance,
                          shadeHit(frame, mirrored, hit, random));
    const Light& light = frame.world->light;
    const glm::vec3 sky =
        skyThroughAir(frame, mirrored.origin, mirrored.direction, light.sky(mirrored.direction));
    constexpr float sharp = 0.1f * static_cast<float>(sunRadius);
    return withSun ? sky + light.sunDisc(mirrored.direction, sharp) : sky;
}

/// Times Fresnel, averaged over samples.
glm::vec3 roughMirror(const Frame& frame, const Ray& ray, const Hit& hit, Random& random) {
    const FloorDesc& floor = frame.world->floor->desc;
    const FloorPlane& plane = frame.world->floor->plane;
    const auto alpha = static_cast<float>(floor.roughness * floor.roughness);
    const glm::mat3 world(glm::vec3(plane.across), glm::vec3(plane.along), glm::vec3(plane.normal));
    const glm::vec3 v = -ray.direction;
    const glm::vec3 facet = world * visibleFacet(glm::transpose(world) * v, alpha, random.next2());
    const Ray mirrored = mirroredRay(ray, hit, facet);
    const float leaves = glm::dot(mirrored.direction, hit.facing());
    if (leaves <= 0) return glm::vec3(0); // into a neighbouring facet
    const float fresnel = schlick(static_cast<float>(floor.reflectance), std::max(glm::dot(v, facet), 0.0f));
    return fresnel * ggxVisible(leaves, alpha) * radianceOf(frame, mirrored, false, &random);
}

struct Ground {
    glm::vec3 diffuse;
    float polish; ///< of the coat
};

Ground groundAt(const Frame& frame, const Ray& ray, const Hit& hit) {
    const Floor& floor = *frame.world->floor;
    const auto perMetre = static_cast<float>(1 / floor.desc.textureM);
    const glm::vec3 across(floor.plane.across), along(floor.plane.along);
    const auto uv = [&](const glm::vec3& p) {
        return glm::vec2(glm::dot(p, across), glm::dot(p, along)) * perMetre;
    };
    const glm::vec3 middle(floor.plane.middle - frame.camera.eye);
    const Spread spread = spreadOn(ray.footprint, hit.position, hit.facing());
    const glm::vec4 texel =
        floor.texture.sample(uv(hit.position - middle), uv(spread.right), uv(spread.below));
    return {glm::vec3(toGlm(floor.desc.color)) * glm::vec3(texel), texel.a};
}

} // namespace

Ray mirrorOfFloor(const Ray& ray, const Hit& hit) {
    return mirroredRay(ray, hit, hit.facing());
}

glm::vec3 shadeFloor(const Frame& frame, const Ray& ray, const Hit& hit, Random* random) {
    const FloorDesc& floor = frame.world->floor->desc;
    const Light& light = frame.world->light;
    const Ground ground = groundAt(frame, ray, hit);
    const glm::vec3 n = hit.facing(), v = -ray.direction, l = light.toSun();
    const float nDotL = glm::dot(n, l), nDotV = std::max(glm::dot(n, v), 1e-3f);
    const auto roughness = static_cast<float>(floor.roughness);
    const bool rough = roughness > 0 && random;

    const float coat = coatFresnel(floor, nDotV);
    const glm::vec3 mirrored =
        rough ? roughMirror(frame, ray, hit, *random)
              : coat * radianceOf(frame, mirrorOfFloor(ray, hit), roughness == 0, random);
    glm::vec3 down = light.irradiance(n), glint(0);
    const glm::vec3 towardsSun = random ? light.towardsSun(random->next2()) : l;
    const bool lit = nDotL > 0 && light.sunIrradiance() != glm::vec3(0) &&
                     !frame.geometry.occluded(hit.position + n * clearanceAt(hit.position), towardsSun,
                                              Kind::opaque, ray.footprint);
    if (lit) {
        const glm::vec3 sun = light.sunIrradiance() * nDotL;
        down += sun;
        // A perfect mirror shows the disc itself.
        if (roughness > 0)
            glint = sun * sunSpecular(n, v, l, nDotL, nDotV, glm::vec3(static_cast<float>(floor.reflectance)),
                                      std::max(roughness, 0.06f));
    }
    const glm::vec3 radiance =
        ground.diffuse / pi * down * (1 - ground.polish * coat) + (mirrored + glint) * ground.polish;
    return glm::min(radiance, glm::vec3(60000));
}

} // namespace demos::reference
