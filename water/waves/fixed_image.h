// An image whose content is known when it is made: uploaded by the first frame, and never written again.
#pragma once

#include "gpu/context.h"
#include "gpu/memory/buffer.h"
#include "gpu/memory/image.h"

namespace seaglass {

class FixedImage {
  public:
    /// `desc.usage` is added to. Its texels are to be written to texels(), mip by mip and in each layer by
    /// layer.
    Status create(Context& context, const gpu::ImageDesc& desc, const char* what);
    std::byte* texels() const { return static_cast<std::byte*>(staging_.mapped()); }
    /// The image and its staging.
    static VkDeviceSize bytes(const gpu::Device& device, const gpu::ImageDesc& desc);
    /// Uploads on its first call, does nothing after.
    void recordUpload(const gpu::Device& device, VkCommandBuffer commands);
    VkImageView view() const { return image_.view(); }

  private:
    gpu::OwnedImage image_;
    gpu::Buffer staging_;
    bool uploaded_ = false;
};

} // namespace seaglass
