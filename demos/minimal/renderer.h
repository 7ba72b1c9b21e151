// The renderer as it was before it had water: a triangle, drawn into HDR colour and reversed depth, without a
// window.
#pragma once

#include <cstdint>

#include <vulkan/vulkan.h>

namespace minimal {

constexpr VkExtent2D size{640, 360};
constexpr VkFormat colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT, depthFormat = VK_FORMAT_D32_SFLOAT;

/// Ends the program if not.
void check(bool ok, const char* what);

struct Gpu {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t family = 0;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
};

VkInstance createInstance();
/// On the first queue family that draws. The features of Vulkan 1.3 want dynamicRendering and
/// synchronization2.
Gpu createGpu(VkInstance instance, VkPhysicalDevice physical, const VkPhysicalDeviceFeatures2& features);
void destroyGpu(const Gpu& gpu);

struct Picture {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

Picture createPicture(const Gpu& gpu, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage);
void destroyPicture(const Gpu& gpu, const Picture& picture);
/// Changes the layout and waits for everything before; a renderer that overlaps frames names stages.
void become(const Gpu& gpu, const Picture& picture, VkImageLayout from, VkImageLayout to);
/// Of an attachment, which it is again afterwards, for shaders to read.
void copy(const Gpu& gpu, const Picture& from, const Picture& to);

/// Column-major, double.
struct Camera {
    double view[16];
    double projection[16];
};

/// Draws the triangle.
struct Triangle {
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE;
};

Triangle createTriangle(const Gpu& gpu);
void destroyTriangle(const Gpu& gpu, const Triangle& triangle);
void draw(const Gpu& gpu, const Triangle& triangle, const Camera& camera);

void beginCommands(const Gpu& gpu);
void beginPass(const Gpu& gpu, const Picture& color, const Picture& depth, VkAttachmentLoadOp load);
/// Submits, waits and writes the colour, an attachment, as PPM.
void finish(const Gpu& gpu, const Picture& color, const char* file);

} // namespace minimal
