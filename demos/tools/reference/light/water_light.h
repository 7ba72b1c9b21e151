// shaders/water/body/water_light.glsl and underwater_light.glsl on the CPU: what water absorbs and sends
// back.
#pragma once

#include "reference/frame.h"
#include "reference/shade/optics.h"

namespace demos::reference {

struct WaterLight {
    glm::vec3 absorption{1e-5f}, backscatter{0}; ///< [1/m]
    glm::vec3 entering{0};                       ///< irradiance just below the surface
    glm::vec3 enteringFromSky{0};                ///< the part of it that shadows leave

    glm::vec3 extinction() const { return absorption + backscatter; }
    /// All that is scattered, forwards too [1/m]: particles send 0.0183 of it back (Petzold 1972), and
    /// molecules, which sea water owes this much to (Morel 1974), half.
    glm::vec3 scattering() const {
        const glm::vec3 byMolecules = glm::min(backscatter, glm::vec3(0.00046f, 0.00095f, 0.00227f));
        return 2.0f * byMolecules + (backscatter - byMolecules) / 0.0183f;
    }
    /// Radiance of endless water below, seen from just under its surface (Morel and Prieur 1977).
    glm::vec3 deep() const { return entering / pi * (0.33f * backscatter / extinction()); }
    /// What `path` metres send back, seen above the surface.
    glm::vec3 glow(float path) const {
        constexpr float leaves = 0.98f / (waterIndex * waterIndex);
        return deep() * leaves * (1.0f - glm::exp(-2.0f * extinction() * path));
    }
    /// What `path` metres that begin at `depth` and rise by `rise` a metre scatter into a ray.
    glm::vec3 scatteredIn(float depth, float rise, float path) const;
};

WaterLight waterLightOf(const Frame& frame);

/// Whether a point relative to the eye lies under the surface, of water that may be seen from within.
bool isInWater(const Frame& frame, const glm::vec3& position);

/// What is left of `radiance` from the end of a ray's first `length` metres in water, with what they scatter
/// in.
glm::vec3 throughWater(const Frame& frame, const Ray& ray, float length, const glm::vec3& radiance);
/// The same for what nothing but water is seen of.
glm::vec3 endlessWater(const Frame& frame, const Ray& ray);

} // namespace demos::reference
