#include "reference/shade/shade_opaque.h"

#include <algorithm>
#include <cmath>

#include "reference/shade/ggx.h"

namespace demos::reference {
namespace {

/// Specular reflectance of a rough surface in uniform light (Karis 2014, "Physically Based Shading on
/// Mobile").
glm::vec3 environmentBrdf(const glm::vec3& f0, float roughness, float nDotV) {
    const glm::vec4 r =
        roughness * glm::vec4(-1.0f, -0.0275f, -0.572f, 0.022f) + glm::vec4(1.0f, 0.0425f, 1.04f, -0.04f);
    const float a = std::min(r.x * r.x, std::exp2(-9.28f * nDotV)) * r.x + r.y;
    const glm::vec2 ab = glm::vec2(-1.04f, 1.04f) * a + glm::vec2(r.z, r.w);
    return f0 * ab.x + ab.y;
}

} // namespace

glm::vec3 normalAt(const Hit& hit) {
    const Mesh& mesh = hit.part->model->mesh;
    glm::vec3 n(0);
    for (int i = 0; i < 3; ++i)
        n += hit.weights[i] *
             mesh.vertices[mesh.indices[size_t(hit.triangle) * 3 + static_cast<size_t>(i)]].normal;
    n = glm::normalize(hit.part->eyeFromMesh * n);
    return hit.frontFacing ? n : -n;
}

glm::vec3 lightLeavesFrom(const Hit& hit) {
    const Mesh& mesh = hit.part->model->mesh;
    const float side = hit.frontFacing ? 1.0f : -1.0f;
    glm::vec3 smooth(0);
    for (int i = 0; i < 3; ++i) {
        const uint32_t corner = mesh.indices[size_t(hit.triangle) * 3 + static_cast<size_t>(i)];
        const glm::vec3 n = side * glm::normalize(hit.part->eyeFromMesh * mesh.vertices[corner].normal);
        const float below = std::min(glm::dot(hit.position - hit.part->positions[corner], n), 0.0f);
        smooth += hit.weights[i] * (hit.position - below * n);
    }
    return smooth + hit.facing() * clearanceAt(hit.position);
}

glm::vec3 shadeOpaque(const Geometry& geometry, const Light& light, const Ray& ray, const Hit& hit,
                      const Look& look, const glm::vec3& towardsSun) {
    if (look.unlit) return look.emissive;
    const float roughness = look.roughness;
    const glm::vec3 f0 = look.mirrored, diffuse = look.diffuse;

    const glm::vec3 n = mappedNormal(hit, normalAt(hit), ray.footprint);
    const glm::vec3 v = -ray.direction;
    const glm::vec3 l = light.toSun();
    const float nDotL = glm::dot(n, l), nDotV = std::max(std::abs(glm::dot(n, v)), 1e-3f);

    glm::vec3 radiance = look.emissive;
    const bool lit = nDotL > 0 && light.sunIrradiance() != glm::vec3(0);
    if (lit && !geometry.occluded(lightLeavesFrom(hit), towardsSun, Kind::opaque, ray.footprint)) {
        radiance += light.sunIrradiance() * nDotL *
                    (diffuse / pi + sunSpecular(n, v, l, nDotL, nDotV, f0, roughness));
    }
    const glm::vec3 ambient = environmentBrdf(f0, roughness, nDotV);
    // The mip whose texels are as large as the lobe: solid angles 4 pi alpha^2 and 4 pi / (6 size^2).
    const auto& cube = light.filtered.cube;
    const auto lastMip = static_cast<float>(cube.mips.size() - 1);
    const float mip = std::log2(static_cast<float>(cube.faceSize) * roughness * roughness * 2.449f);
    const glm::vec3 mirrored = light.cube(glm::reflect(-v, n), glm::clamp(mip, 0.0f, lastMip - 1));
    radiance += look.open * (diffuse / pi * light.irradiance(n) * (1.0f - ambient) + mirrored * ambient);
    return glm::min(radiance, glm::vec3(60000));
}

} // namespace demos::reference
