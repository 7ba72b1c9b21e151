// Multisampled scenes, made single-sampled before a technique reads them: of each pixel sample 0, its depth
// and its own colour. Of colour that the host has resolved, which along edges is of both sides, that of the
// least mixed pixel around: else what stands before water wears an outline of what lies behind it. A mean of
// depths lies on no surface, and the nearest of a pixel's samples would stand now here, now there in it; one
// sample throughout keeps planes plane, and is as near to the middle as any. Reading it once and writing it
// down is cheaper than for each of the techniques to pick it out of a multisampled image, again and again.
#pragma once

#include <array>
#include <memory>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel.h"
#include "gpu/view/limits.h"
#include "gpu/view/view.h"

namespace seaglass {

struct DepthSampleKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

struct ColorSampleKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

struct ResolvedColorKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Of one view, as large as the host's own images; empty where those hold one sample.
struct SingleSampledScene {
    gpu::OwnedImage depth; ///< R32F
    gpu::OwnedImage color; ///< RGBA16F
    bool fits(const ViewDesc& view) const;
    /// Gives `view` these images for its own multisampled ones, to be sampled.
    void standIn(ViewDesc& view) const;
    Status create(const gpu::Device& device, const ViewDesc& view);
    /// `depth`: of the host's own.
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, VkSampleCountFlagBits depth);
    static uint32_t dispatches(VkSampleCountFlagBits depth);
};

/// What all reflectors of a context share: a scene is picked out once, however many mirrors show it.
struct SingleSamples {
    std::shared_ptr<DepthSampleKernel> depth; ///< null until a view hands in images that need them
    std::shared_ptr<ColorSampleKernel> color;
    std::shared_ptr<ResolvedColorKernel> resolved;
    std::array<SingleSampledScene, maxViews> views;
    Status create(Context&) { return Status::ok; }
};

/// Makes the kernels that a multisampled view needs, where `samples` has them not.
Status shareKernels(Context& context, const ViewDesc& view, SingleSamples& samples);

/// The scene of one call, which its reflectors read one after the other.
struct SceneOfCall {
    explicit SceneOfCall(const ViewDesc& view) : given(view), read(view) {}
    const ViewDesc& given;
    ViewDesc read; ///< with single-sampled images once those are taken
    bool taken = false;
};

/// What single-sampled hosts never pay for.
inline bool isMultisampled(const ViewDesc& view) {
    return hasScene(view) && view.sceneDepth.samples != VK_SAMPLE_COUNT_1_BIT;
}

/// Sample 0 of `image`, within the region of `view`, to be sampled from `to`; `kernel` is of what it holds.
/// `resolved`: null but for ResolvedColorKernel, whose `image` is the depth.
Status recordFirstSample(Context& context, VkCommandBuffer commands, const gpu::Kernel& kernel,
                         const ViewGeometry& view, const gpu::OwnedImage& to, const Image& image,
                         const Image* resolved = nullptr);

/// What that writes.
gpu::ImageDesc firstDepthDesc(VkExtent2D extent);
gpu::ImageDesc firstColorDesc(VkExtent2D extent);

/// For all who read the scene of a call: the first fills the region of its view's single-sampled images and
/// leaves them to be sampled in `scene.read`. `samples` is what the reader holds of them, null until a view
/// has many.
Status takeSamples(Context& context, VkCommandBuffer commands, const ViewGeometry& view,
                   std::shared_ptr<SingleSamples>& samples, SceneOfCall& scene);

/// Lets go of what a view held that has many samples no longer.
void dropSamples(Context& context, SingleSamples* samples, uint32_t viewIndex);

} // namespace seaglass
