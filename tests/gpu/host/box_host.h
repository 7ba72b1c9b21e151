// A host that draws boxes with one pipeline: in its main pass, and once more wherever Seaglass asks for it.
#pragma once

#include <vector>

#include "host/vulkan/resources.h"
#include "seaglass/reflection.h"
#include "tests/gpu/rig/traced_scene.h"
#include "tests/unit/cameras.h"

namespace tests {

class BoxHost {
  public:
    /// A main pass by VkRenderPass, or by dynamic rendering; multisampled as `drawn` says, then resolved.
    BoxHost(const seaglass::DrawnDesc& drawn, bool renderPass, std::vector<Box> boxes);

    /// Into images of its own.
    void drawMain(VkCommandBuffer commands, const Camera& camera);
    /// From images that were sampled to what reflect() takes over.
    void drawAgain(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view);
    /// What was recorded has been done.
    void finished() { inUse_.clear(); }

  private:
    struct Attachments {
        VkExtent2D extent = {0, 0};
        VkImageView color = VK_NULL_HANDLE, depth = VK_NULL_HANDLE;
        VkImageView resolved = VK_NULL_HANDLE; ///< null: the colour is not
    };
    /// What the GPU needs until it is done.
    struct InUse {
        demos::Image color, depth, resolved;
        demos::Unique<VkFramebuffer, &vkDestroyFramebuffer> framebuffer;
    };
    using Pass = demos::Unique<VkRenderPass, &vkDestroyRenderPass>;

    Pass createPass(bool resolves) const;
    void createPipeline();
    demos::Image createImage(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples,
                             VkImageUsageFlags usage) const;
    void toAttachment(VkCommandBuffer commands, const demos::Image& image, VkImageLayout layout) const;
    void draw(VkCommandBuffer commands, const Attachments& into, VkRenderPass pass,
              const VkViewport& viewport, const glm::dmat4& clipFromWorld, float clearDepth, bool mirrored,
              InUse& inUse);
    void begin(VkCommandBuffer commands, const Attachments& into, VkRenderPass pass, float clearDepth,
               InUse& inUse) const;
    bool many() const { return drawn_.samples.depth != VK_SAMPLE_COUNT_1_BIT; }

    seaglass::DrawnDesc drawn_;
    std::vector<Box> boxes_;
    Pass main_;  ///< null by dynamic rendering
    Pass again_; ///< compatible with it
    demos::UniquePipelineLayout layout_;
    demos::UniquePipeline pipeline_;
    std::vector<InUse> inUse_;
};

} // namespace tests
