// The least that drawing a whole picture can cost: a triangle over it, whose pixels are read from another
// one.
#pragma once

#include "host/vulkan/frame_targets.h"
#include "host/vulkan/one_texture.h"

namespace demos {

class FullScreenPass {
  public:
    bool create(const Device& device, Error& error);
    /// Draws targets.sceneColor over targets.color, both as copyScene() leaves them.
    void record(const Device& device, VkCommandBuffer commands, const FrameTargets& targets) const;

  private:
    OneTexture drawing_;
};

} // namespace demos
