// demos/host/shaders/opaque.frag on the CPU.
#pragma once

#include "reference/geometry.h"
#include "reference/light/light.h"

namespace demos::reference {

/// Where rays from an opaque hit to light begin: on the round thing that its triangles stand for, by their
/// corners' normals, or triangles near the terminator would lie in their own shadow (Hanika 2021, "Hacking
/// the Shadow Terminator").
glm::vec3 lightLeavesFrom(const Hit& hit);

/// Unit, on the side that the ray met.
glm::vec3 normalAt(const Hit& hit);

/// Radiance towards where the ray came from. `towardsSun` is a direction to a point of the sun's disc: a ray
/// is traced there in place of the host's shadow map.
glm::vec3 shadeOpaque(const Geometry& geometry, const Light& light, const Ray& ray, const Hit& hit,
                      const Look& look, const glm::vec3& towardsSun);

} // namespace demos::reference
