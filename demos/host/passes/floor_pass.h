// A compute copy of a frame's colour and depth: what costs are given as multiples of.
#pragma once

#include "host/vulkan/resources.h"

namespace demos {

class FloorPass {
  public:
    /// RGBA16F and R32F of this size, twice.
    bool create(Device& device, VkExtent2D extent, Error& error);
    /// After what was recorded of it before.
    void record(VkCommandBuffer commands) const;

  private:
    bool createImages(Device& device, VkExtent2D extent, Error& error);
    bool createSet(const Device& device, Error& error);
    bool createPipeline(const Device& device, Error& error);

    Image images_[4]; ///< from: colour, depth; to: colour, depth
    UniqueDescriptorSetLayout setLayout_;
    UniqueDescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    UniquePipelineLayout layout_;
    UniquePipeline pipeline_;
};

} // namespace demos
