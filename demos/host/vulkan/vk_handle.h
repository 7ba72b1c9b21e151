// Vulkan handles that destroy themselves. The functions come from volk, so nothing links the loader.
#pragma once

#include <utility>

#include <volk.h>

namespace demos {

/// Owns one device object; `destroy` is volk's pointer to the function that ends it.
template<class Handle, auto* destroy>
class Unique {
  public:
    Unique() = default;
    Unique(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    Unique(Unique&& other) noexcept
        : device_(other.device_), handle_(std::exchange(other.handle_, Handle(VK_NULL_HANDLE))) {}
    Unique& operator=(Unique&& other) noexcept {
        if (this != &other) {
            reset();
            device_ = other.device_;
            handle_ = std::exchange(other.handle_, Handle(VK_NULL_HANDLE));
        }
        return *this;
    }
    ~Unique() { reset(); }

    void reset() {
        if (handle_ != Handle(VK_NULL_HANDLE)) (*destroy)(device_, handle_, nullptr);
        handle_ = Handle(VK_NULL_HANDLE);
    }
    const Handle& get() const { return handle_; }
    explicit operator bool() const { return handle_ != Handle(VK_NULL_HANDLE); }

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
};

using UniqueBuffer = Unique<VkBuffer, &vkDestroyBuffer>;
using UniqueCommandPool = Unique<VkCommandPool, &vkDestroyCommandPool>;
using UniqueDescriptorPool = Unique<VkDescriptorPool, &vkDestroyDescriptorPool>;
using UniqueDescriptorSetLayout = Unique<VkDescriptorSetLayout, &vkDestroyDescriptorSetLayout>;
using UniqueFence = Unique<VkFence, &vkDestroyFence>;
using UniqueImage = Unique<VkImage, &vkDestroyImage>;
using UniqueImageView = Unique<VkImageView, &vkDestroyImageView>;
using UniqueMemory = Unique<VkDeviceMemory, &vkFreeMemory>;
using UniquePipeline = Unique<VkPipeline, &vkDestroyPipeline>;
using UniquePipelineLayout = Unique<VkPipelineLayout, &vkDestroyPipelineLayout>;
using UniqueQueryPool = Unique<VkQueryPool, &vkDestroyQueryPool>;
using UniqueSampler = Unique<VkSampler, &vkDestroySampler>;
using UniqueShaderModule = Unique<VkShaderModule, &vkDestroyShaderModule>;
using UniqueSwapchain = Unique<VkSwapchainKHR, &vkDestroySwapchainKHR>;

} // namespace demos
