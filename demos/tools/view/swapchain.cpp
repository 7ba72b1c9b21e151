#include "view/swapchain.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace demos {

namespace {

VkImageMemoryBarrier2 wholeImage(VkImage image) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    return barrier;
}

void record(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

VkOffset3D corner(VkExtent2D extent) {
    return {static_cast<int32_t>(extent.width), static_cast<int32_t>(extent.height), 1};
}

} // namespace

Swapchain::~Swapchain() {
    swapchain_.reset();
    if (surface_) vkDestroySurfaceKHR(device_->instance(), surface_, nullptr);
}

bool Swapchain::create(Device& device, GLFWwindow* window, Error& error) {
    device_ = &device;
    if (!succeeded(glfwCreateWindowSurface(device.instance(), window, nullptr, &surface_),
                   "glfwCreateWindowSurface", error))
        return false;
    VkBool32 presents = VK_FALSE;
    if (!succeeded(vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queueFamily(), surface_,
                                                        &presents),
                   "vkGetPhysicalDeviceSurfaceSupportKHR", error))
        return false;
    if (!presents) {
        error.text = device.info().name + " cannot draw into windows of this display";
        return false;
    }
    const VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    if (!succeeded(vkCreateFence(device.handle(), &info, nullptr, &fence), "vkCreateFence", error))
        return false;
    acquired_ = UniqueFence(device.handle(), fence);
    return chooseFormat(error);
}

bool Swapchain::chooseFormat(Error& error) {
    uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(device_->physical(), surface_, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    vkGetPhysicalDeviceSurfaceFormatsKHR(device_->physical(), surface_, &count, formats.data());
    // The picture comes encoded: a copy into an sRGB image would encode it once more.
    const auto found = std::ranges::find_if(formats, [](const VkSurfaceFormatKHR& candidate) {
        return (candidate.format == VK_FORMAT_B8G8R8A8_UNORM ||
                candidate.format == VK_FORMAT_R8G8B8A8_UNORM) &&
               candidate.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
    });
    if (found == formats.end()) {
        error.text = "the window takes no pictures of 8 bits a channel";
        return false;
    }
    format_ = *found;
    return true;
}

bool Swapchain::resize(VkExtent2D wanted, Error& error) {
    VkSurfaceCapabilitiesKHR can{};
    if (!succeeded(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &can),
                   "vkGetPhysicalDeviceSurfaceCapabilitiesKHR", error))
        return false;
    if (!(can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT)) {
        error.text = "the window takes no copied pictures";
        return false;
    }
    extent_ = can.currentExtent;
    if (extent_.width == UINT32_MAX) {
        extent_.width = std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width);
        extent_.height = std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height);
    }
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface_;
    info.minImageCount = std::max(2u, can.minImageCount);
    if (can.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = can.currentTransform;
    info.compositeAlpha = can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain_.get();
    // What was presented last may still be read.
    if (!device_->checked(vkDeviceWaitIdle(device_->handle()), "vkDeviceWaitIdle", error)) return false;
    VkSwapchainKHR made = VK_NULL_HANDLE;
    if (!succeeded(vkCreateSwapchainKHR(device_->handle(), &info, nullptr, &made), "vkCreateSwapchainKHR",
                   error))
        return false;
    swapchain_ = UniqueSwapchain(device_->handle(), made);
    uint32_t count = 0;
    vkGetSwapchainImagesKHR(device_->handle(), made, &count, nullptr);
    images_.resize(count);
    return succeeded(vkGetSwapchainImagesKHR(device_->handle(), made, &count, images_.data()),
                     "vkGetSwapchainImagesKHR", error);
}

bool Swapchain::acquire(uint64_t waitNs, Acquired& acquired, Error& error) {
    const VkResult result = vkAcquireNextImageKHR(device_->handle(), swapchain_.get(), waitNs, VK_NULL_HANDLE,
                                                  acquired_.get(), &image_);
    acquired = result == VK_ERROR_OUT_OF_DATE_KHR               ? Acquired::stale
               : result == VK_TIMEOUT || result == VK_NOT_READY ? Acquired::none
                                                                : Acquired::image;
    if (acquired != Acquired::image) return true;
    return (result == VK_SUBOPTIMAL_KHR || device_->checked(result, "vkAcquireNextImageKHR", error)) &&
           device_->waitFor(acquired_.get(), error);
}

void Swapchain::record(VkCommandBuffer commands, const Image& picture) const {
    VkImageMemoryBarrier2 barrier = wholeImage(images_[image_]);
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    demos::record(commands, barrier);
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.srcOffsets[1] = corner(picture.extent);
    blit.dstOffsets[1] = corner(extent_);
    vkCmdBlitImage(commands, picture.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, images_[image_],
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_NEAREST);
    barrier.srcAccessMask = barrier.dstAccessMask;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_NONE;
    barrier.dstAccessMask = 0;
    barrier.oldLayout = barrier.newLayout;
    barrier.newLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    demos::record(commands, barrier);
}

bool Swapchain::present(bool& stale, Error& error) {
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_.get();
    info.pImageIndices = &image_;
    const VkResult result = vkQueuePresentKHR(device_->queue(), &info);
    stale = result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR;
    return stale || device_->checked(result, "vkQueuePresentKHR", error);
}

} // namespace demos
