// A triangle over a whole picture, whose pixels are made from others.
#pragma once

#include "host/vulkan/layouts.h"
#include "host/vulkan/resources.h"

namespace demos {

class PicturePass {
  public:
    /// Of a fragment shader that reads `textures` pictures from binding 0 on, the last between its texels as
    /// well, and constants of so many bytes.
    bool create(const Device& device, std::span<const uint32_t> fragment, uint32_t textures,
                uint32_t constantBytes, bool blends, Error& error);
    bool exists() const { return pipeline_.get() != VK_NULL_HANDLE; }
    /// Another set of pictures to read, for as long as `pool` lives.
    bool allocate(const Device& device, std::span<const VkImageView> pictures, UniqueDescriptorPool& pool,
                  VkDescriptorSet& set, Error& error) const;
    /// Draws over all of an attachment, which is kept where the pass blends.
    void record(VkCommandBuffer commands, const Image& target, VkDescriptorSet set,
                const void* constants) const;

  private:
    uint32_t textures_ = 0, constantBytes_ = 0;
    UniqueSampler nearest_, linear_;
    UniqueDescriptorSetLayout setLayout_;
    UniquePipelineLayout layout_;
    UniquePipeline pipeline_;
};

/// What was drawn is read by fragment shaders, and what they read is drawn to.
void drawnToRead(VkCommandBuffer commands, const Image& image);
/// From `before`, in which nobody but fragment shaders read it.
void readToDrawn(VkCommandBuffer commands, const Image& image,
                 VkImageLayout before = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

/// To be drawn to and read, of colours as FrameTargets has them.
bool createPicture(const Device& device, VkExtent2D extent, Image& out, Error& error);

} // namespace demos
