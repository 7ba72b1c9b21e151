// A lat-long sky as light: clean pixels, the sun taken out, a filtered cube and the irradiance it gives. CPU
// only.
//
// The left edge of the image faces +X, a quarter to its right is +Z: azimuth = 360 u, elevation = 90 - 180 v.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "scene/surroundings.h"

namespace demos {

struct SkyImage {
    uint32_t width = 0, height = 0;
    std::vector<glm::vec3> radiance; ///< top row first, finite, 0 or more
};

/// The sun as the image shows it, in the image's own frame and scale.
struct ImageSun {
    glm::dvec3 direction{0, 1, 0};
    glm::dvec3 irradiance{0}; ///< what was taken out of the image
};

struct SkyCube {
    uint32_t faceSize = 0;
    /// Per mip, six faces in Vulkan's order. Each level is the one before it blurred by about one of its own
    /// texels.
    std::vector<std::vector<glm::vec3>> mips;
};

struct SkyLight {
    SkyCube cube;
    std::array<glm::vec3, 9> irradianceSh{}; ///< polynomial of the unit normal, see shaders/frame.glsl
    glm::vec3 irradianceUp{0};               ///< on a horizontal plane facing +Y
};

/// Direction of a point on a cube face, s and t from -1 to 1 and a little beyond (Vulkan 1.3, "Cube Map Face
/// Selection", solved for the direction). Of no unit length.
glm::dvec3 faceDirection(uint32_t face, double s, double t);

/// Empty for a clear sky, which chooseSun() makes. Else reads an HDR or EXR of up to 16384 pixels' width,
/// averaged down to at most 4096. NaN takes its left neighbour's value, infinity is taken for 1e7, and
/// negative pixels for 0.
std::optional<SkyImage> readSkyImage(const SkyDesc& sky, Error& error);

/// Cuts the sun's disc out of the image: around the brightest pixel above the horizon, what exceeds the
/// brightest pixel of the ring just outside the disc is taken away. Its irradiance is returned, so that image
/// plus sun keep the energy they had.
ImageSun takeOutSun(SkyImage& image);

/// Radiance from a direction of the image's own frame, bilinear.
glm::vec3 sampleSky(const SkyImage& image, const glm::dvec3& direction);

/// Radiance of the cube from a direction, trilinear, as a GPU filters it across the faces' edges.
glm::vec3 sampleCube(const SkyCube& cube, const glm::dvec3& direction, float mip);

/// Filters the image, turned about +Y (from +X towards +Z) and scaled.
SkyLight filterSky(const SkyImage& image, double rotationDeg, double intensity);

} // namespace demos
