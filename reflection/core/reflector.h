// What is behind seaglass::Reflector: one plane, one technique, and the images of each view that looked at
// it.
#pragma once

#include <array>
#include <memory>

#include <glm/vec4.hpp>

#include "gpu/fields.h"
#include "gpu/view/limits.h"
#include "gpu/view/single_sample.h"
#include "reflection/after/blur.h"
#include "reflection/after/edge_reach.h"
#include "reflection/after/stretch.h"
#include "reflection/after/temporal.h"
#include "reflection/core/bounds.h"
#include "reflection/core/technique.h"
#include "reflection/debug/overlay.h"

namespace seaglass {

/// What a reflector keeps for one view.
struct ReflectedView {
    OwnedReflection images;
    std::shared_ptr<void> scratch; ///< the technique's
    TemporalScratch temporal;      ///< empty without temporal reuse
    gpu::Buffer allTiles;          ///< in the place of the technique's: empty where it has some, or none asks
    bool reflected = false;        ///< the images hold what reflect() has left
    bool bent = false;             ///< by the view's own normals
    VkExtent2D region = {0, 0};    ///< the view's, in pixels
    uint32_t downscale = 1;        ///< of the images
    uint64_t frame = 0;            ///< Context::frameNumber of the last reflect()
    double clipFromWorld[16] = {}; ///< of the view then
    bool isOf(VkExtent2D extent) const { return gpu::isSame(region, extent); }
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    /// What techniques write.
    OwnedReflection& found(const ReflectionDesc& desc) { return desc.temporal > 0 ? temporal.found : images; }
    /// Whose flags say where the technique's images are looked up.
    const gpu::Buffer& tiles(const Technique& technique) const {
        return technique.tiles ? technique.tiles(scratch.get()) : allTiles;
    }
    template<typename Scratch>
    Scratch& scratchOf() const {
        return *static_cast<Scratch*>(scratch.get());
    }
};

/// Of a reflector with a usable description.
Estimate estimateOf(const gpu::Device& device, const ReflectionDesc& desc, VkExtent2D extent,
                    const SceneSamples& samples);

/// What is wrong with a description, if anything is.
FieldError badField(const ReflectionDesc& desc);
/// The same, said, and what this device cannot do.
Status check(const gpu::Device& device, const ReflectionDesc& desc);

struct Reflector : Held {
    glm::dvec4 plane{0}; ///< world, unit normal
    double raised = 0;   ///< by which what is mirrored next lies above it [m]
    Bounds bounds;
    ReflectionDesc desc;
    std::shared_ptr<void> kernels;                ///< the technique's
    std::shared_ptr<EdgeReachKernel> edgeReach;   ///< null without edge reach
    std::shared_ptr<StretchKernel> stretch;       ///< null without edge stretch
    std::shared_ptr<BlurKernel> blur;             ///< null without blur
    std::shared_ptr<TemporalKernel> temporal;     ///< null without temporal reuse
    std::shared_ptr<SingleSamples> singleSamples; ///< null until a view has many
    std::shared_ptr<OverlayKernel> overlay;       ///< null until it is first asked for
    std::array<ReflectedView, maxViews> views;

    Status create(Context& owner, const ReflectorDesc& description);
    Status handOut(const ViewDesc& view, PlanarView& out);
    Status record(VkCommandBuffer commands, SceneOfCall& scene);
    Status drawOverlay(VkCommandBuffer commands, const ViewDesc& view, const OverlayDesc& overlayDesc);
    ReflectionImages images(uint32_t viewIndex) const;
    glm::dvec4 mirroredPlane() const { return plane - glm::dvec4(0, 0, 0, raised); }
    const Technique& technique() const { return techniqueOf(desc.technique); }
    /// How soon it is to be renewed for a view; 0: never.
    uint64_t urgency(const ViewGeometry& geometry, uint32_t viewIndex) const;

  private:
    /// Makes what a view of this size needs, where it is not there yet.
    Status prepare(ReflectedView& view, VkExtent2D extent);
    /// What follows on every technique, where it is asked for: edge reach, stretch, temporal reuse, blur.
    Status recordAfter(const ReflectPass& pass, ReflectedView& reflected);
    Status uploadMirror(const ViewDesc& view, const ViewGeometry& geometry, const glm::ivec4& shown,
                        gpu::Slice& out);
};

} // namespace seaglass
