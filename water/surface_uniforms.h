// What the shaders of a body's surface and of its water are told about one view of it.
#pragma once

#include <cstdint>

#include <glm/mat3x4.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "reflection/view.h"
#include "seaglass/water.h"
#include "water/cascades.h"
#include "water/dry_rooms.h"

namespace seaglass {

constexpr uint32_t maxShadowCascades = 4;

/// The std140 block of shaders/common/surface_uniforms.glsl. Positions are relative to the eye, in the body's
/// axes.
struct SurfaceUniforms {
    glm::mat4 clipFromRelative{1};
    glm::mat4 pixelFromRelative{1};
    glm::mat4 relativeFromPixel{1};      ///< of the scene's pixels; for motion, the last frame's pixels of
                                         ///< points relative to this frame's eye
    glm::vec4 cascade[maxCascades] = {}; ///< eye's (u, v) in the tile, in tiles; 1 / patch; 1 / texel [1/m]
    glm::vec4 plane{0, 1, 0, 0};         ///< up, and the eye's height [m]
    glm::vec4 sight{0, 0, 0, 1};         ///< direction of parallel lines of sight, and 0; else 0, and 1
    glm::vec4 toSun{0};
    glm::vec4 sunIrradiance{0};
    glm::vec4 skyIrradiance{0};
    glm::vec4 absorption{0}; ///< and scattering by particles [1/m]
    glm::vec4 backscatter{0};
    glm::ivec4 region{0};
    glm::vec4 foam{0};      ///< share of the way from the history's first step to its second, albedo, the
                            ///< eye's place in the pattern's longest tile [m]
    glm::vec4 roughness{0}; ///< slope covariance that no cascade holds: uu, vv, uv; the deviation of all
                            ///< slopes of the sea, mean of both directions
    float refractionDistortion = 0;
    float reflectionDistortion = 0;
    float farDepth = 0;
    float depthSign = 1;
    float skyMips = 1;
    int32_t cascades = 0;
    float maxMip = 0;
    float reflectionScale = 1; ///< pixels of the region to one of the reflection, each way
    int32_t foamCascades = 0;  ///< that break: the first so many
    glm::vec2 foamStreak{0};   ///< wind's direction, times sqrt(1 - 1/stretch) of the pattern
    float padding = 0;
    glm::vec4 reflectionLook{
        0};                  ///< clear distance [m], scatter, distance at which the sky has taken over [m]
    glm::vec4 within{0};     ///< edge of the finest cells, half the meniscus, deviation of heights, distance
                             ///< of ParallelLines [m]
    glm::vec2 sceneShift{0}; ///< ViewGeometry's [pixel]
    float shiftPadding[2] = {};
    glm::vec4 extent{0}; ///< (u, v) of the origin of a mesh of the host's own; 1 / distance over which edges
                         ///< hold the waves, and Globe::curvature [1/m]
    glm::vec4 sunInWater{0};                     ///< SunInWater::from
    glm::vec4 sunTurned{0};                      ///< SunInWater: turnedAlong, turnedAcross
    glm::vec4 lostSlopes[2]{};                   ///< LostSlopes
    glm::ivec4 causticGrid{0};                   ///< CausticGrid: step, margin, rowLength, firstRow
    glm::vec4 caustics{0};                       ///< strength
    glm::vec4 covered{-1e9f, -1e9f, 1e9f, 1e9f}; ///< (u, v) of the box around the body, low and high [m]
    glm::vec4 shorePlace{0};                     ///< of the eye on the shore's map, and of a metre
    glm::vec4 shoreSignal{0};     ///< rows a second, the first one's, their number; the map's spacing [m]
    glm::vec4 shoreForm{0};       ///< 1 / period; how far foam is carried for each metre of swash; the first
                                  ///< row in the last frame
    glm::mat3x4 worldFromBody{1}; ///< a column each
    glm::vec4 dryPlanes[maxDryRooms * dryRoomPlanes] = {}; ///< of each room: outside is positive [m]
    glm::mat4 shadowFromRelative[maxShadowCascades] = {};  ///< to u, v and depth of SunShadow's cascades
    glm::vec4 shadowBounds[maxShadowCascades] = {};
    glm::vec4 shadowLayers{0};
    glm::vec4 shadow{0};          ///< cascades; 1, or -1 where what is nearer to the sun is greater
    glm::mat4 bedFromRelative{1}; ///< to the pixels of the bed's picture
    glm::mat4 relativeFromBed{1};
    glm::ivec2 bedSize{0}; ///< of that picture [pixel]
    float bedPadding[2] = {};
    glm::vec4 skyZenith{0}; ///< radiance of a sky without a cube
    glm::vec4 skyHorizon{0};
    glm::vec4 skyGround{0};
    FogBlock fog{};
};

struct BedPicture;

/// For points relative to an `eye` in the body's axes.
void setBed(SurfaceUniforms& uniforms, const BedPicture& bed, const glm::dvec3& eye);

SurfaceUniforms surfaceUniforms(const Body& body, const ViewGeometry& geometry, const LightingDesc& lighting);

} // namespace seaglass
