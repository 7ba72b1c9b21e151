// The renderer of renderer.h before it has water.   triangle OUT.ppm
//
// `patch -p1 < sea.diff` gives it an open sea; pond.cpp is what all that it may add looks like.
#include <cstdio>
#include <initializer_list>

#include "renderer.h"

using namespace minimal;

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: triangle OUT.ppm\n");
        return 2;
    }
    const VkInstance instance = createInstance();
    VkPhysicalDevice chosen = VK_NULL_HANDLE;
    uint32_t count = 1; // the first will do
    vkEnumeratePhysicalDevices(instance, &count, &chosen);
    minimal::check(chosen != VK_NULL_HANDLE, "finding a device");
    VkPhysicalDeviceVulkan13Features features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    features.synchronization2 = features.dynamicRendering = VK_TRUE;
    const Gpu gpu =
        createGpu(instance, chosen, {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features, {}});
    constexpr VkImageUsageFlags read = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const Picture color = createPicture(gpu, colorFormat, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | read);
    const Picture depth =
        createPicture(gpu, depthFormat, size, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | read);
    const Triangle triangle = createTriangle(gpu);
    // The eye is 1.7 m up and 6 m back. An infinite far plane, reversed depth, y down as Vulkan has it.
    constexpr double tangent = 0.414, nearest = 0.1, aspect = 640.0 / 360;
    const Camera camera = {
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.7, -6, 1},
        {1 / (aspect * tangent), 0, 0, 0, 0, -1 / tangent, 0, 0, 0, 0, 0, -1, 0, 0, nearest, 0}};

    beginCommands(gpu);
    become(gpu, color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    become(gpu, depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    beginPass(gpu, color, depth, VK_ATTACHMENT_LOAD_OP_CLEAR);
    draw(gpu, triangle, camera);
    vkCmdEndRendering(gpu.commands);
    finish(gpu, color, argv[1]);

    destroyTriangle(gpu, triangle);
    for (const Picture& picture : {color, depth}) destroyPicture(gpu, picture);
    destroyGpu(gpu);
    return 0;
}
