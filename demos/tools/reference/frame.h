// One picture's worth of a world: what rays hit from this eye at this time.
#pragma once

#include "reference/light/caustics.h"
#include "reference/light/light_below.h"
#include "reference/random.h"
#include "reference/shade/wet_sand.h"
#include "reference/world.h"

namespace demos::reference {

struct FrameDesc {
    uint32_t width = 1280, height = 720;
    CameraDesc camera;
    double timeS = 0;
    uint32_t samples = 1; ///< of each pixel; 1 is its centre
    uint64_t seed = 1;
    uint32_t threads = 0; ///< 0: as many as the machine has; the picture does not depend on it
};

/// In the axes of the world's water.
struct Frame {
    const World* world = nullptr;
    FrameDesc desc;
    Camera camera;
    float pixelAngle = 0; ///< [rad], as seen from the apex of first rays
    float apexM = 0;      ///< how far that lies behind where they begin
    WaterSurface surface;
    SurfaceMesh mesh; ///< without its positions, which the geometry holds, but among exclusion volumes
    Geometry geometry;
    std::vector<ExcludedVolume> excludedVolumes; ///< the world's, and those that meshes carry along
    WettedShore shore;
    SkyBeams sky; ///< under water; dark where there is none
    Caustics caustics;

    /// Through a point of the picture, in pixels from its left top corner, for as many of them as `width`
    /// each way.
    Ray rayThrough(const glm::vec2& pixel, float width = 1) const;
    /// Where in the picture a point relative to the eye is seen; z is its distance along the view axis, not
    /// positive behind the eye.
    glm::dvec3 seenAt(const glm::vec3& position) const;
    /// Along the line of sight to a point relative to the eye, from where it begins [m].
    float distanceTo(const glm::vec3& position) const;
    /// Whether there is water at a point of a triangle of its surface.
    bool covers(uint32_t triangle, const glm::vec3& weights) const;
    /// (u, v) where the water of a hit rests.
    glm::dvec2 calmAt(const Hit& waterHit) const;
    glm::dvec2 calmAt(uint32_t triangle, const glm::vec3& weights) const;
    /// Height of a point relative to the eye above the calm water [m].
    float heightOf(const glm::vec3& position) const;
    /// Turns what is level at a point relative to the eye, on its globe, into the world's axes.
    glm::mat3 levelAt(const glm::vec3& position) const;
    /// The sky that is seen from there: each place has its own over it.
    glm::vec3 skyFrom(const glm::vec3& position, const glm::vec3& direction) const;

  private:
    /// Where it and the next pixels' rays begin, relative to the eye.
    Ray parallelRay(const glm::dvec3& from, const glm::dvec3& right, const glm::dvec3& below,
                    float angle) const;
};

/// `out` keeps a pointer to the world, and its geometry one to `out`.
bool prepareFrame(const World& world, const FrameDesc& desc, Frame& out, Error& error);

} // namespace demos::reference
