// Rough surfaces of opaque things and of floors: demos/host/shaders/sunlight.glsl on the CPU, and its facets
// drawn at random.
#pragma once

#include <cmath>

#include "reference/shade/optics.h"

namespace demos::reference {

/// GGX with the height-correlated Smith term (Heitz 2014), Fresnel by Schlick.
inline glm::vec3 sunSpecular(const glm::vec3& n, const glm::vec3& v, const glm::vec3& l, float nDotL,
                             float nDotV, const glm::vec3& f0, float roughness) {
    const glm::vec3 h = glm::normalize(v + l);
    const float nDotH = glm::clamp(glm::dot(n, h), 0.0f, 1.0f),
                vDotH = glm::clamp(glm::dot(v, h), 0.0f, 1.0f);
    const float alpha = roughness * roughness, a2 = alpha * alpha;
    const float d = nDotH * nDotH * (a2 - 1) + 1;
    const float smith =
        nDotL * std::sqrt(nDotV * nDotV * (1 - a2) + a2) + nDotV * std::sqrt(nDotL * nDotL * (1 - a2) + a2);
    const glm::vec3 f = f0 + (1.0f - f0) * std::pow(1 - vDotH, 5.0f);
    return f * (a2 / (pi * d * d)) * (0.5f / std::max(smith, 1e-5f));
}

/// Smith's masking of GGX, the visible share of facets towards a direction with this cosine.
inline float ggxVisible(float cosine, float alpha) {
    const float c2 = cosine * cosine;
    return 2 * cosine / (cosine + std::sqrt(alpha * alpha * (1 - c2) + c2));
}

/// The normal of a facet that is seen from `v`, drawn by how much of it is seen (Heitz 2018); `v` and the
/// result have the surface's normal along +Z.
inline glm::vec3 visibleFacet(const glm::vec3& v, float alpha, const glm::vec2& at) {
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * v.x, alpha * v.y, v.z));
    const float squared = stretched.x * stretched.x + stretched.y * stretched.y;
    const glm::vec3 right =
        squared > 0 ? glm::vec3(-stretched.y, stretched.x, 0) / std::sqrt(squared) : glm::vec3(1, 0, 0);
    const glm::vec3 up = glm::cross(stretched, right);
    const float radius = std::sqrt(at.x), turn = 2 * pi * at.y, half = 0.5f * (1 + stretched.z);
    const float x = radius * std::cos(turn);
    const float y = (1 - half) * std::sqrt(std::max(1 - x * x, 0.0f)) + half * radius * std::sin(turn);
    const glm::vec3 facet = x * right + y * up + std::sqrt(std::max(1 - x * x - y * y, 0.0f)) * stretched;
    return glm::normalize(glm::vec3(alpha * facet.x, alpha * facet.y, std::max(facet.z, 0.0f)));
}

} // namespace demos::reference
