// Light that strays in the lens: a small share of each pixel's goes to those around it, and none is lost.
// Pictures of half the size each, and back (Jimenez 2014), without a threshold.
#pragma once

#include <vector>

#include "host/lens/picture_pass.h"
#include "host/vulkan/frame_targets.h"

namespace demos {

/// As in shaders/bloom.frag, which copies where nothing is blurred.
struct BloomConstants {
    float pixel[2], reach[2] = {0, 0}, share = 1;
};

class Bloom {
  public:
    /// Readies it for frames in these targets.
    bool fit(const Device& device, const FrameTargets& targets, Error& error);
    /// Drops what it holds for them.
    void drop() { levels_.clear(); }
    /// Over targets.color, an attachment before and after.
    void record(VkCommandBuffer commands, const FrameTargets& targets) const;

  private:
    struct Level {
        Image image;
        UniqueDescriptorPool pool, sourcePool;
        VkDescriptorSet set = VK_NULL_HANDLE;       ///< to read it
        VkDescriptorSet sourceSet = VK_NULL_HANDLE; ///< to read what it is made from
    };

    PicturePass smaller_, larger_; ///< the one replaces, the other adds by a share
    std::vector<Level> levels_;    ///< largest first
};

} // namespace demos
