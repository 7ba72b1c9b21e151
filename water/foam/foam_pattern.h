// The pattern that foam breaks up into: a tile of bubble rafts and lace, made once from a fixed seed, with
// mips.
#pragma once

#include <cstdint>
#include <vector>

#include "seaglass/sea.h"
#include "water/waves/fixed_image.h"

namespace seaglass {

constexpr uint32_t foamPatternSamples = 256;

/// Edge of the tile that it repeats in [m]; shaders/water/foam/foam_cover.glsl samples divisions of it.
constexpr double foamTile = 24.0;

/// After this [m] the parts of the tile that places show come round again.
constexpr double foamRepeat = 16 * foamTile;

/// A place of the pattern, as four bytes of a texel.
struct FoamTexel {
    uint8_t pattern = 0; ///< evenly distributed over 0..255: `pattern < cover` covers a share `cover`
    uint8_t bend = 0;    ///< smooth noise of its own, which bends the edge of what is foamy
    uint8_t slopeU = 0, slopeV = 0; ///< 128 + 128 of how the foam rises, in foamReliefStep a texel
};
constexpr float foamReliefStep = 0.1f; ///< of the pattern, a texel

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

/// Mip by mip from foamPatternSamples^2 texels on, rows along u; tiles without a seam.
std::vector<std::vector<FoamTexel>> foamPattern();

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
