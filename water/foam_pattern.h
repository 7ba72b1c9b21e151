// The pattern that foam breaks up into: a tile of bubble rafts and lace, made once from a fixed seed.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/context.h"
#include "gpu/image.h"

namespace seaglass {

constexpr uint32_t foamPatternSamples = 256;

/// foamPatternSamples^2 bytes, evenly distributed over 0..255 so that `pattern < cover` covers a share
/// `cover`; tiles without a seam.
std::vector<uint8_t> foamPattern();

class FoamPattern {
  public:
    Status create(Context& context);
    static VkDeviceSize bytes();
    /// Uploads on its first call, does nothing after.
    void recordUpload(const gpu::Device& device, VkCommandBuffer commands);
    VkImageView view() const { return image_.view(); }

  private:
    gpu::OwnedImage image_;
    gpu::Buffer staging_;
    bool uploaded_ = false;
};

} // namespace seaglass
