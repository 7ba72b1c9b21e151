// A forward renderer as tutorials teach it: instance, device, swapchain, render pass, framebuffers,
// pipelines, and a loop with two frames in flight. Depth runs forward: 0 at the near plane, 1 at the far one.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>
#include <vulkan/vulkan.h>

#include "scene.h"

constexpr VkFormat swapchainFormat = VK_FORMAT_B8G8R8A8_SRGB;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;
/// In place of VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, which only images of a window have.
constexpr VkImageLayout presentedLayout = VK_IMAGE_LAYOUT_GENERAL;

struct AllocatedBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

struct AllocatedImage {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    uint32_t layers = 1;
};

/// What a frame in flight has of its own.
struct FrameData {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence rendered = VK_NULL_HANDLE;
};

struct Mesh {
    AllocatedBuffer vertices;
    uint32_t vertexCount = 0;
};

/// Ends the program if not.
void check(VkResult result, const char* what);

class Engine {
  public:
    explicit Engine(VkExtent2D extent);
    ~Engine();

    /// The next frame.
    void draw();
    /// The frame drawn last, as PPM.
    void savePicture(const char* file);

  private:
    static constexpr uint32_t framesInFlight = 2;

    void createDevice();
    void createSwapchain();
    /// Of the passes of a frame the first clears, and the last leaves the picture to be presented.
    VkRenderPass createRenderPass(bool first, bool last);
    void createFramebuffers();
    void createFrames();
    void createScene();
    void createPipeline();

    uint32_t acquireNextImage();
    void present(uint32_t image);
    void beginPass(VkCommandBuffer commands, VkRenderPass pass, uint32_t image);
    void drawScene(VkCommandBuffer commands);

    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted);
    AllocatedBuffer createBuffer(VkDeviceSize bytes, VkBufferUsageFlags usage);
    AllocatedImage createImage(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                               uint32_t layers = 1);
    void* map(const AllocatedBuffer& buffer);
    void submitNow(const std::function<void(VkCommandBuffer)>& record);
    /// Waits for all that was recorded before. Engines name stages; tutorials start so.
    static void transition(VkCommandBuffer commands, const AllocatedImage& image, VkImageLayout from,
                           VkImageLayout to);

    const VkExtent2D extent_;
    /// Run from the back: what was made last goes first.
    std::vector<std::function<void()>> deletions_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;

    std::vector<AllocatedImage> swapchain_;
    AllocatedImage depth_;
    VkRenderPass renderPass_ = VK_NULL_HANDLE;
    std::vector<VkFramebuffer> framebuffers_;
    FrameData frames_[framesInFlight];
    uint32_t frameNumber_ = 0;
    uint32_t presented_ = 0;

    Camera camera_;
    std::vector<Mesh> meshes_;
    VkPipelineLayout pipelineLayout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};
