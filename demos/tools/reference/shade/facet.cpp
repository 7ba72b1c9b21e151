#include "reference/shade/facet.h"

#include <algorithm>
#include <cmath>

#include "reference/shade/optics.h"

namespace demos::reference {
namespace {

float travelledUntil(const Ray& ray, const Hit& hit) {
    return glm::length(ray.origin - ray.footprint.apex) + hit.distance;
}

/// Which way normals point to the ray: 1 up, -1 down.
float sideOf(const Hit& hit) {
    return hit.frontFacing ? 1.0f : -1.0f;
}

/// Two independent unit normals as slopes of this covariance: Cholesky's factor.
glm::vec2 correlated(const glm::vec3& covariance, const glm::vec2& normals) {
    const float u = std::sqrt(std::max(covariance.x, 1e-12f));
    const float mixed = covariance.z / u;
    return {u * normals.x,
            mixed * normals.x + std::sqrt(std::max(covariance.y - mixed * mixed, 0.0f)) * normals.y};
}

} // namespace

float footprintOn(const Ray& ray, const Hit& hit) {
    const Spread spread = spreadOn(ray.footprint, hit.position, hit.facing());
    const float right = glm::length(glm::vec2(spread.right.x, spread.right.z));
    const float below = glm::length(glm::vec2(spread.below.x, spread.below.z));
    return std::max(right, below);
}

float foamWidth(const Ray& ray, const Hit& hit, const Random* random) {
    constexpr float point = 1e-3f;
    return random ? point : footprintOn(ray, hit);
}

Facet meanFacet(const Frame& frame, const Ray& ray, const Hit& hit) {
    Facet f;
    f.up = hit.facing();
    f.slopes = frame.surface.slopes(frame.calmAt(hit), static_cast<double>(footprintOn(ray, hit)));
    f.normal = frame.levelAt(hit.position) * (sideOf(hit) * normalOf(f.slopes.mean));
    if (glm::dot(f.normal, ray.direction) > -1e-3f) f.normal = f.up;
    return f;
}

Facet randomFacet(const Frame& frame, const Ray& ray, const Hit& hit, float leastCosine, Random& random) {
    Facet f;
    f.up = hit.facing();
    f.slopes = frame.surface.slopes(frame.calmAt(hit), 0);
    const glm::vec2 slope = f.slopes.mean + correlated(f.slopes.covariance, random.nextNormal());
    const glm::mat3 level = frame.levelAt(hit.position);
    const float upright = std::abs(glm::dot(f.up, level[1]));
    f.meshCosine = std::max(-glm::dot(ray.direction, f.up) / std::max(upright, 0.05f), leastCosine);
    const float seen = -sideOf(hit) * glm::dot(ray.direction, level * glm::vec3(-slope.x, 1, -slope.y));
    // A trace is kept of facets seen from behind, so that no pixel's sum is empty.
    f.weight = std::clamp(seen / f.meshCosine, 1e-4f, 20.0f);
    f.normal = seen > 0 ? level * (sideOf(hit) * normalOf(slope)) : f.up;
    return f;
}

Ray bentRay(const Ray& ray, const Hit& hit, const glm::vec3& side, const glm::vec3& direction) {
    Ray bent;
    bent.origin = hit.position + side * clearanceAt(hit.position);
    bent.direction = direction;
    bent.footprint = footprintAfter(bent.origin, direction, travelledUntil(ray, hit), ray.footprint.angle);
    return bent;
}

} // namespace demos::reference
