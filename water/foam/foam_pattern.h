// The pattern that foam breaks up into: a tile of bubble rafts and lace, made once from a fixed seed, with
// mips.
#pragma once

#include "seaglass/sea.h"
#include "water/interface/foam_texels.h"
#include "water/waves/fixed_image.h"

namespace seaglass {

/// Edge of the tile that it repeats in [m]; shaders/water/foam/foam_cover.glsl samples divisions of it.
constexpr double foamTile = 24.0;

/// After this [m] the parts of the tile that places show come round again.
constexpr double foamRepeat = 16 * foamTile;

/// How the wind draws the pattern out: a place p has what lies at p - w (w.p) of the tile.
struct FoamStreak {
    double u = 0, v = 0; ///< w: the wind's direction, times sqrt(1 - 1/stretch)

    void apply(double& placeU, double& placeV) const {
        const double along = u * placeU + v * placeV;
        placeU -= u * along;
        placeV -= v * along;
    }
};
FoamStreak foamStreakOf(const SeaDesc& sea);

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
