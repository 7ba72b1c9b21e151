// The surface as it is drawn: which shader a body's features need, its pipelines, and one draw.
#pragma once

#include <cstdint>
#include <span>

#include "gpu/context.h"
#include "gpu/pipeline/constants.h"
#include "seaglass/water.h"
#include "water/body/draw_pipeline.h"
#include "water/mesh/placing.h"

namespace seaglass {

/// Which sides of it a view may see.
enum class SidesSeen : uint32_t { above = 0, below, either };

/// What the pipeline of a surface depends on beside its body.
struct SurfaceDraw {
    SurfaceOutput output = SurfaceOutput::shaded;
    SidesSeen sides = SidesSeen::above;
    bool seesScene = true; ///< the view has the scene's images
    bool sceneIsEncoded = false;
    bool manySamples = false;       ///< of the scene
    bool isAhead = false;           ///< of pipelines that are made before anything is drawn
    const ViewDesc* view = nullptr; ///< null where it is ahead of any
    const LightingDesc* lighting = nullptr;
    bool isMotion() const { return output == SurfaceOutput::motion; }
};

/// A pipeline for each: it declares nothing that its constants leave out.
struct SurfaceVariant {
#define CONSTANTS "shaders/shared/surface_constants.h"
#include "gpu/pipeline/constants.inl"
    auto operator<=>(const SurfaceVariant&) const = default;
};

/// What says where the surface is, and where it is cut.
SurfaceVariant shapeVariant(const SurfaceVariant& all);

/// Of the surface's mesh, by a fragment shader.
Status buildMeshPipeline(const gpu::Device& device, const TargetDesc& target,
                         std::span<const uint32_t> fragment, const SurfaceVariant& variant, const char* what,
                         DrawPipeline& out);

/// Those of a mesh that a draw takes.
struct Instances {
    uint32_t first = 0, count = 0;
};

struct InstancesDraw {
    const DrawPipeline* pipeline = nullptr;
    Instances drawn;
};

/// `resources`: all that some pipeline's shaders read, but for the mesh.
Status recordSurface(Context& context, VkCommandBuffer commands, std::span<const InstancesDraw> draws,
                     const PlacedMesh& mesh, std::vector<gpu::Bound> resources, uint32_t viewIndex);

} // namespace seaglass
