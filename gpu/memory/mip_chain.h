// Mip chains by halving.
#pragma once

#include <memory>
#include <span>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel.h"

namespace seaglass::gpu {

struct MipKernel {
    Kernel kernel;
};

/// Makes the mips of some images together: on GPUs all of them by two dispatches, as large as wave maps are;
/// by blits, two barriers and a blit a mip and image, on CPU devices, which store to images slowly.
class MipChain {
  public:
    /// Of so many images of `format`: three of RGBA32F or one of RG16F.
    Status create(Context& context, VkFormat format);
    /// That images need for it, besides what fills their mip 0.
    static VkImageUsageFlags usage(const Device& device);

    /// Fills every mip of each image from its mip 0, which `written` has left, all layers, and leaves all of
    /// them to be sampled by shaders. What the other mips held is lost. All images are of one size and have
    /// as many mips, and views that are arrays. Each mip is the linear filter's mean of the one before;
    /// extents halve without rest.
    Status record(Context& context, VkCommandBuffer commands, std::span<const OwnedImage* const> images,
                  const Use& written) const;

  private:
    std::shared_ptr<MipKernel> kernel_; ///< null where it blits
};

} // namespace seaglass::gpu
