// The surface as it is drawn: which shader a body's features need, its pipelines, and one draw.
#pragma once

#include <cstdint>

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/bed.h"
#include "water/draw_pipeline.h"

namespace seaglass {

/// How the vertices of a surface are placed.
enum class SurfaceShape : uint32_t {
    plane,    ///< patches out to the horizon
    outlined, ///< patches, of which pixels within an outline are kept
    hostMesh, ///< the host's own
};

/// What a body's surface has. Each combination is a shader of its own, which declares nothing that it does
/// not use.
struct SurfaceFeatures {
    bool waves = false;
    bool foam = false; ///< only with waves
    bool refraction = false;
    bool reflection = false; ///< a screen-space reflection image
    bool shore = false;      ///< only with waves
    SurfaceShape shape = SurfaceShape::plane;
    uint32_t cascades = 0;
    uint32_t foamCascades = 0;    ///< that break: the first so many
    bool crestLight = false;      ///< only with waves and refraction
    uint32_t dryRooms = 0;        ///< roomsPacked()
    uint32_t mirrorLooks = 0;     ///< only with waves
    uint32_t refractionLooks = 0; ///< only with refraction
    uint32_t slopeLooks = 0;      ///< only with waves
    uint32_t waveShadowSteps = 0; ///< likewise
    bool relief = false;          ///< only with waves and without a shore
    bool sunShadow = false;       ///< a shadow map of the host's
    bool tilted = false;          ///< its axes are not the world's
    bool globe = false;           ///< it lies on one; only of the shape `plane`
    uint32_t sharpDownscale = 0;  ///< of a reflection without mips, only without waves
    uint32_t bedDownscale = 0;    ///< only with refraction: of the bed's picture it looks at; 0: at none
    bool schlick = false;         ///< in place of the exact formula
    bool skyColors = false;       ///< in place of the sky's cube
    uint32_t fog = 0;             ///< fogKind()
    bool motion = false;          ///< beside it waves, shore, shape and dryRooms alone
    bool sceneEncoded = false;    ///< only with refraction: what is read of the scene
    bool manySamples = false;     ///< only with refraction: of the scene's depth
    auto operator<=>(const SurfaceFeatures&) const = default;
};

/// Which sides of it a view may see.
enum class SidesSeen : uint32_t { above = 0, below, either };

/// A pipeline for each.
struct SurfaceVariant {
    SurfaceFeatures features;
    SurfaceOutput output = SurfaceOutput::shaded;
    SidesSeen sides = SidesSeen::above;
    auto operator<=>(const SurfaceVariant&) const = default;
};

using SurfacePipelines = DrawPipelines<SurfaceVariant>;
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SurfaceVariant& variant,
                     DrawPipeline& out);

/// What one draw binds. Views that the features do not call for stay null.
struct SurfaceInputs {
    gpu::Slice uniforms;
    gpu::Resource patches; ///< one an instance; of a mesh of the host's own, its vertices
    gpu::Resource extent;  ///< the block of shaders/common/extent.glsl
    VkBuffer indices = VK_NULL_HANDLE;
    VkIndexType indexType = VK_INDEX_TYPE_UINT16;
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    uint32_t instanceCount = 1;
    const LightingDesc* lighting = nullptr;
    VkImageView waveMaps[3] = {};
    VkImageView shoreMap = VK_NULL_HANDLE;
    gpu::Resource shoreRows;
    VkImageView lastDisplacement = VK_NULL_HANDLE;
    VkImageView foamPattern = VK_NULL_HANDLE;
    VkImageView foamHistory = VK_NULL_HANDLE;
    ReflectionImages reflection;
    const BedPicture* bed = nullptr;
    const ViewDesc* view = nullptr;
};

Status recordSurface(Context& context, VkCommandBuffer commands, const DrawPipeline& pipeline,
                     SurfaceFeatures features, const SurfaceInputs& inputs);

} // namespace seaglass
