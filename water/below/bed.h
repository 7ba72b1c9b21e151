// What lies below a body, as a picture of its own that the host draws: a little wider than the view's,
// without what stands above the water, and from above the eye, where rays come from that the surface bends.
// There they find what the view's own picture ends before, or hides behind a pool's edge or a bank.
#pragma once

#include <array>

#include <glm/vec2.hpp>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/view/limits.h"
#include "gpu/view/single_sample.h"
#include "gpu/view/view.h"
#include "seaglass/water.h"
#include "water/body/body_frame.h"

namespace seaglass {

/// Of one view.
struct BedPicture {
    gpu::OwnedImage color; ///< that the host draws into
    gpu::OwnedImage depth;
    gpu::OwnedImage firstColor; ///< sample 0 of each pixel, where those have many; else empty
    gpu::OwnedImage firstDepth;
    ViewGeometry camera;    ///< in the body's axes, region and pixels as the images have them
    bool handedOut = false; ///< the host was told what to draw since it was taken last
    uint64_t taken = 0;     ///< in what frame
    Status create(const gpu::Device& device, const DrawnDesc& drawn, VkExtent2D extent);
    /// What shaders sample.
    VkImageView colorRead() const { return (firstColor.handle() ? firstColor : color).view(); }
    VkImageView depthRead() const { return (firstDepth.handle() ? firstDepth : depth).view(); }
};

struct Bed {
    BedDesc desc;
    uint32_t downscale = 1;                        ///< ShadingDesc's
    double distortion = 1;                         ///< RefractionDesc's
    std::shared_ptr<DepthSampleKernel> firstDepth; ///< null but of many samples
    std::shared_ptr<ColorSampleKernel> firstColor;
    std::array<BedPicture, maxViews> views;

    /// `made` has the description alone.
    static Status create(Context& context, Bed& made);
    /// What the host is to draw: as `view` was given, what lies below `plane`, of the world.
    /// `geometry`: the view's, in the body's axes.
    Status handOut(Context& context, const ViewDesc& view, const ViewGeometry& geometry,
                   const glm::dvec4& plane, const BodyFrame& frame, PlanarView& out);
    /// From attachments, as the host has left them, to be sampled; of views that were not handed out nothing.
    Status take(Context& context, VkCommandBuffer commands, uint32_t viewIndex);
    /// Null where the view has none in this frame.
    const BedPicture* of(const Context& context, uint32_t viewIndex) const;
    /// Of its picture.
    static VkExtent2D pictureExtent(const BedDesc& desc, uint32_t downscale, VkExtent2D view);
    static VkDeviceSize bytes(const gpu::Device& device, const BedDesc& desc, uint32_t downscale,
                              VkExtent2D view);
    /// Of one view.
    static uint32_t dispatches(const BedDesc& desc);

  private:
    Status takeFirstSamples(Context& context, VkCommandBuffer commands, const BedPicture& picture) const;
};

} // namespace seaglass
