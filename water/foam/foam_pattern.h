// The pattern that foam breaks up into: a tile of bubble rafts and lace, made from a fixed seed, with mips.
#pragma once

#include "water/interface/foam_texels.h"
#include "water/waves/fixed_image.h"

namespace seaglass {

/// For Context::share(): the same for all bodies, and it takes longer to make than all else of a body.
class FoamPattern {
  public:
    Status create(Context& context);
    /// Uploads on its first call, does nothing after.
    void recordUpload(const gpu::Device& device, VkCommandBuffer commands) {
        image_.recordUpload(device, commands);
    }
    VkImageView view() const { return image_.view(); }

  private:
    FixedImage image_;
};

} // namespace seaglass
