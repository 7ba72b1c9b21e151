// The sun as calm water bends its rays. Sheared along the surface by its depth, what lies under water has
// them straight again, so that one shadow map holds what is above and what is below.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "host/camera.h"
#include "host/vulkan/layouts.h"

namespace demos {

struct WaterDesc;

/// Of a sea; of calm water all 0.
struct BendingWaves {
    double slopeVariance = 0; ///< both axes together
    double height = 0;        ///< significant [m]
};

/// Where in the world it is bent, and how. Of one water: a frame has no other.
struct BentSun {
    bool bends = false;
    glm::dvec3 normal{0, 1, 0}; ///< of the calm surface, normal.p + offset = 0; unit
    double offset = 0;
    glm::dvec3 shear{0}; ///< of a point on each metre of its depth, along the surface
    /// Along the surface, two deviations of where its slopes send rays on each metre of depth.
    std::array<glm::dvec3, 2> strays{};
    double troughs = 0;                         ///< depth to which something may stand out of the water [m]
    glm::dvec3 across{1, 0, 0}, along{0, 0, 1}; ///< axes of u and v
    glm::dvec2 middle{0};                       ///< in u and v, of the box that the water fills
    glm::dvec2 half{std::numeric_limits<double>::infinity()}; ///< of that box's sides

    double depthOf(const glm::dvec3& p) const { return -(glm::dot(normal, p) + offset); }
};

/// False with `error` set when the file of an extent cannot be read.
bool bentSunOf(const WaterDesc& water, const glm::dvec3& toSun, const BendingWaves& waves, BentSun& out,
               Error& error);

/// How much of a box lies where rays are bent.
struct BentShare {
    bool some = false, all = false;
};
BentShare shareOf(const BentSun& sun, std::span<const glm::dvec3, 8> corners);

/// Moves what is under water; relative to the eye.
glm::dmat4 shearFromEye(const BentSun& sun, const glm::dvec3& eye);

void setBentUniforms(const BentSun& sun, const glm::dvec3& eye, FrameUniforms& uniforms);
/// The same for another eye, `step` from the one that they are of.
void moveBentUniforms(const glm::dvec3& step, FrameUniforms& uniforms);

} // namespace demos
