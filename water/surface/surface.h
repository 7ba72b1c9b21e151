// The surface as it is drawn: which shader a body's features need, its pipelines, and one draw.
#pragma once

#include <cstdint>

#include "gpu/context.h"
#include "gpu/pipeline/constants.h"
#include "seaglass/water.h"
#include "water/below/bed.h"
#include "water/body/draw_pipeline.h"

namespace seaglass {

/// How the vertices of a surface are placed.
enum class SurfaceShape : uint32_t {
    plane,    ///< patches out to the horizon
    outlined, ///< patches, of which pixels within an outline are kept
    hostMesh, ///< the host's own
};

/// Which sides of it a view may see.
enum class SidesSeen : uint32_t { above = 0, below, either };

/// A pipeline for each: it declares nothing that its constants leave out.
struct SurfaceVariant {
#define CONSTANTS "shaders/shared/surface_constants.h"
#include "gpu/pipeline/constants.inl"
    auto operator<=>(const SurfaceVariant&) const = default;
};

using SurfacePipelines = DrawPipelines<SurfaceVariant>;
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SurfaceVariant& variant,
                     DrawPipeline& out);

/// What one draw binds. Views that its variant does not call for stay null.
struct SurfaceInputs {
    gpu::Slice uniforms;
    gpu::Resource patches; ///< one an instance; of a mesh of the host's own, its vertices
    gpu::Resource extent;  ///< the block of shaders/water/mesh/extent.glsl
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
                     const SurfaceInputs& inputs);

} // namespace seaglass
