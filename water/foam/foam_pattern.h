// The pattern that foam breaks up into: a tile of bubble rafts and lace, made once from a fixed seed, with
// mips.
#pragma once

#include "water/interface/foam_texels.h"
#include "water/waves/fixed_image.h"

namespace seaglass {

/// Edge of the tile whose divisions rafts and lace repeat in [m], as in shaders/water/foam/foam_cover.glsl.
constexpr double foamTile = 24.0;

/// After this [m] the parts of the tile that places show come round again.
constexpr double foamRepeat = 16 * foamTile;

/// Edge of the tile of its windrows [m].
constexpr double windrowTile = 160.0;

class FoamPattern {
  public:
    Status create(Context& context);
    static VkDeviceSize bytes(const gpu::Device& device);
    /// Uploads on its first call, does nothing after.
    void recordUpload(const gpu::Device& device, VkCommandBuffer commands) {
        image_.recordUpload(device, commands);
    }
    VkImageView view() const { return image_.view(); }

  private:
    FixedImage image_;
};

} // namespace seaglass
