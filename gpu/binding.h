// Descriptor sets as shaders see them: a list of resources, binding 0 first.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace seaglass::gpu {

struct Resource {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
};

inline Resource uniformBuffer(VkBuffer buffer, VkDeviceSize offset, VkDeviceSize range) {
    return {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {buffer, offset, range}, {}};
}
inline Resource storageBuffer(VkBuffer buffer, VkDeviceSize offset = 0, VkDeviceSize range = VK_WHOLE_SIZE) {
    return {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {buffer, offset, range}, {}};
}
inline Resource sampledImage(VkSampler sampler, VkImageView view,
                             VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) {
    return {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, {}, {sampler, view, layout}};
}
inline Resource storageImage(VkImageView view) {
    return {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, {}, {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}};
}

/// One set's layout and the pipeline layout that uses it, with push constants for `stages`.
class Layout {
  public:
    Layout() = default;
    ~Layout() { release(); }
    Layout(Layout&& other) noexcept { *this = std::move(other); }
    Layout& operator=(Layout&& other) noexcept;

    Status create(const Device& device, std::span<const VkDescriptorType> bindings, VkShaderStageFlags stages,
                  uint32_t pushConstantBytes, const char* what);

    VkDescriptorSetLayout set() const { return set_; }
    VkPipelineLayout pipeline() const { return pipeline_; }
    /// Whose it is, for messages and debuggers.
    const char* what() const { return what_.c_str(); }

  private:
    void release();

    const Device* device_ = nullptr;
    VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
    VkPipelineLayout pipeline_ = VK_NULL_HANDLE;
    std::string what_;
};

} // namespace seaglass::gpu
