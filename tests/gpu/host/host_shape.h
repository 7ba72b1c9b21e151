// Hosts of one shape or another, each of which draws the same water over the same scene.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "host/vulkan/device.h"
#include "host/vulkan/resources.h"
#include "seaglass/water.h"
#include "tests/unit/host_worlds.h"

namespace tests {

/// What a host hands over of its scene.
enum class SceneGiven { traced, nothing /*but sky*/, noImages };

struct HostShape {
    const char* name = "Plain";
    VkFormat color = VK_FORMAT_R32G32B32A32_SFLOAT;
    VkFormat depth = VK_FORMAT_D32_SFLOAT;
    bool stencilAttached = false;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    bool renderPass = false; ///< else dynamic rendering
    bool secondary = false;  ///< all of it recorded in secondary command buffers
    bool flipped = false;    ///< y up in clip space, and a viewport of negative height
    bool multiview = false;  ///< all cameras of a frame in one pass
    bool sunShadow = false;  ///< hands in a shadow map, of a sun that nothing hides
    bool depthWrite = true;  ///< by the water
    bool fog = false;        ///< before the water, partly of the sky's colour
    bool skyCube = true;     ///< else colours
    SceneGiven scene = SceneGiven::traced;
    HostWorld world = everyWorld().front();                   ///< in which its cameras and its sun are
    seaglass::Encoding encoding = seaglass::Encoding::linear; ///< of scene, pictures and target
    bool resolvesScene = false; ///< its depth has four samples a pixel, its colour is their mean
    bool copiesDepth = false;   ///< recordSceneCopy() hands the scene's in, of `depth`'s format
};

/// Whether the tests' device has its formats and samples.
bool canDraw(const HostShape& shape);

/// RGBA, rows from the top.
using Picture = std::vector<float>;

/// As displays take it, by the sRGB curve: each colour 0..1.
Picture displayed(const Picture& linear);

/// From the shore: things on the water and under it, which hide some of it from 20 metres on.
Camera shoreCamera();

class ShapedHost {
  public:
    /// `change` alters what the context is told, `changeBody` what the water is.
    explicit ShapedHost(demos::Device& device, const HostShape& shape = {}, bool reversedDepth = true,
                        const std::function<void(seaglass::DeviceDesc&)>& change = {},
                        const std::function<void(seaglass::BodyDesc&)>& changeBody = {});
    ~ShapedHost();
    ShapedHost(const ShapedHost&) = delete;
    ShapedHost& operator=(const ShapedHost&) = delete;

    seaglass::Context* context() const { return context_; }
    seaglass::Body* body() const { return body_; }
    const std::string& message() const { return message_; }

    /// Records a frame of one view for each camera and submits it. The slot's frame before was fetched.
    void submit(uint32_t slot, std::span<const Camera> cameras, double time);
    /// Waits for the slot's frame.
    std::vector<Picture> fetch(uint32_t slot);
    Picture picture(const Camera& camera, double time = 5, uint32_t slot = 0);

  private:
    struct Scene {
        Camera camera;
        demos::Image color, depth;
        demos::Image drawnDepth; ///< of hosts that copy it: what `depth` becomes the copy of
    };
    struct Attachment {
        demos::UniqueMemory memory;
        demos::UniqueImage image;
        demos::UniqueImageView view;
        VkImageAspectFlags aspect = 0;
    };
    /// What one pass draws into.
    struct Targets {
        VkExtent2D extent = {0, 0};
        uint32_t layers = 1;
        Attachment color, depth, manyColors;
        demos::Unique<VkFramebuffer, &vkDestroyFramebuffer> framebuffer;
        demos::Buffer readback;
    };
    struct Slot {
        demos::UniqueCommandPool pool;
        VkCommandBuffer primary = VK_NULL_HANDLE;
        std::vector<VkCommandBuffer> secondaries;
        size_t secondariesUsed = 0;
        demos::UniqueFence fence;
        std::vector<Targets> passes;
    };

    void createLight();
    void createSunShadow();
    void createWater(bool reversedDepth, const std::function<void(seaglass::BodyDesc&)>& change);
    void createRenderPass();
    Attachment createAttachment(VkFormat format, VkExtent2D extent, uint32_t layers,
                                VkSampleCountFlagBits samples, VkImageUsageFlags usage);
    Targets createTargets(VkExtent2D extent, uint32_t layers);
    const Scene& sceneOf(const Camera& camera);
    seaglass::ViewDesc viewOf(const Camera& camera, uint32_t index);
    /// Records in a secondary command buffer where the host has those; else in `primary`. `targets`: within
    /// their pass.
    void record(Slot& slot, const Targets* targets, const std::function<void(VkCommandBuffer)>& commands);
    void copyDepth(VkCommandBuffer commands, const Scene& scene) const;
    /// Nothing lies there.
    void clearBed(VkCommandBuffer commands, const seaglass::ViewDesc& view);
    void beginPass(VkCommandBuffer commands, const Targets& targets, float clearDepth);
    void endPass(VkCommandBuffer commands);
    void readBack(VkCommandBuffer commands, const Targets& targets);
    uint32_t viewMask(uint32_t layers) const { return shape_.multiview ? (1u << layers) - 1 : 0; }

    demos::Device& device_;
    HostShape shape_;
    std::string message_;
    seaglass::Context* context_ = nullptr;
    seaglass::Target* target_ = nullptr;
    seaglass::Body* body_ = nullptr;
    bool caustics_ = false, bed_ = false;
    demos::Image skyCube_, shadowMap_;
    demos::UniqueImageView shadowView_;
    seaglass::SunShadow sunShadow_;
    seaglass::FogDesc fog_;
    seaglass::LightingDesc lighting_;
    demos::Unique<VkRenderPass, &vkDestroyRenderPass> renderPass_;
    std::vector<std::unique_ptr<Scene>> scenes_;
    std::array<Slot, 4> slots_;
};

} // namespace tests
