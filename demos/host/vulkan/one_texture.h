// What draws by one texture, and by that alone.
#pragma once

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"

namespace demos {

class OneTexture {
  public:
    /// Push constants of `constantBytes`; 0: none.
    bool create(const Device& device, const PipelineDesc& desc, uint32_t constantBytes, Error& error);
    /// In SHADER_READ_ONLY_OPTIMAL. Nothing that draws by it is pending.
    void point(const Device& device, VkImageView view) const {
        writeTexture(device, set_, 0, view, sampler_.get());
    }
    /// Whichever way triangles are wound.
    void bind(VkCommandBuffer commands) const;
    void push(VkCommandBuffer commands, std::span<const std::byte> constants) const;

  private:
    UniqueSampler sampler_;
    UniqueDescriptorSetLayout setLayout_;
    UniqueDescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    UniquePipelineLayout layout_;
    UniquePipeline pipeline_;
};

} // namespace demos
