// Where a view shows a surface: its depth, and how far waves moved what shows there, or of motion how far it
// has come in the picture. Drawn outside the host's pass into images of the library's own.
#pragma once

#include <memory>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "water/body/part.h"
#include "water/mesh/placing.h"

namespace seaglass {

/// Of the variants of the surface that place and cut it alike.
struct FoundVariant {
    SurfaceVariant surface;
    auto operator<=>(const FoundVariant&) const = default;
};
/// What finding it depends on.
FoundVariant foundVariant(const SurfaceVariant& all);
Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const FoundVariant& variant,
                     DrawPipeline& out);

/// A pass into images of one kind.
struct FoundPass {
    const gpu::Device* device = nullptr;
    VkFormat beside = VK_FORMAT_UNDEFINED; ///< of what is kept beside depth
    VkRenderPass renderPass = VK_NULL_HANDLE;
    DrawPipelines<FoundVariant> pipelines;

    FoundPass() = default;
    ~FoundPass();
    FoundPass(const FoundPass&) = delete;
    FoundPass& operator=(const FoundPass&) = delete;
    Status create(Context& context, VkFormat keptBeside);
};

/// For what no exclusion volume reaches into, most of the surface, and for the rest: testing for volumes
/// costs more than all else of finding it.
Status getFound(FoundPass& pass, const FoundVariant& variant, const DrawPipeline*& uncut,
                const DrawPipeline*& cut);

/// What all bodies of a context share.
struct FoundPasses {
    FoundPass places, motion;
    Status create(Context& context);
    FoundPass& of(SurfaceOutput output) { return output == SurfaceOutput::motion ? motion : places; }
};

/// Of one view, as large as the largest of its index so far.
class FoundSurface {
  public:
    FoundSurface() = default;
    ~FoundSurface() { release(); }
    FoundSurface(FoundSurface&& other) noexcept { *this = std::move(other); }
    FoundSurface& operator=(FoundSurface&& other) noexcept;

    Status create(const FoundPass& pass, VkExtent2D extent);
    bool holds(VkExtent2D extent) const;
    VkExtent2D extent() const { return depth_.desc().extent; }
    VkImageView depth() const { return depth_.view(); }
    /// How far waves moved it, or its motion.
    VkImageView beside() const { return beside_.view(); }
    /// To be shaded.
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent);

    /// Draws the mesh, and leaves both images to be sampled.
    Status record(Context& context, VkCommandBuffer commands, FoundPass& pass, const FoundVariant& variant,
                  const PlacedMesh& mesh, const Resources& resources, const ViewDesc& view,
                  const ViewGeometry& geometry) const;

  private:
    void begin(VkCommandBuffer commands, const FoundPass& pass, VkExtent2D region) const;
    void release();

    const gpu::Device* device_ = nullptr;
    gpu::OwnedImage depth_, beside_;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

} // namespace seaglass
