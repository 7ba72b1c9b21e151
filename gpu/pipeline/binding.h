// Descriptor sets as shaders declare them, and the resources that they are filled with.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/spirv_bindings.h"

namespace seaglass::gpu {

struct Resource {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
    VkFormat format = VK_FORMAT_UNDEFINED; ///< of storage images
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
inline Resource storageImage(VkImageView view, VkFormat format) {
    return {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, {}, {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}, format};
}
/// One mip.
inline Resource storageImage(const OwnedImage& image, uint32_t mip = 0) {
    return storageImage(image.mipView(mip), image.desc().format);
}

/// A resource and the number that shaders know it by.
struct Bound {
    uint32_t number = 0;
    Resource resource;
};

/// One set's layout and the pipeline layout that uses it.
class Layout {
  public:
    Layout() = default;
    ~Layout() { release(); }
    Layout(Layout&& other) noexcept { *this = std::move(other); }
    Layout& operator=(Layout&& other) noexcept;

    /// Of what a pipeline's modules declare, one a stage. `pushConstantBytes` are of those that have some.
    Status create(const Device& device, std::span<const std::span<const uint32_t>> modules,
                  uint32_t pushConstantBytes, const char* what);

    /// Whether a shader declares this binding.
    bool has(uint32_t number) const { return find(number) != nullptr; }
    /// Refused unless each binding is there once, of the type that shaders declare. What is stored to an
    /// image whose format is not that of its declaration is undefined.
    Status check(std::span<const Bound> resources) const;

    /// Whether a set of one serves the other: they are identically defined.
    bool sharesSets(const Layout& other) const { return interface_.bindings == other.interface_.bindings; }

    VkDescriptorSetLayout set() const { return set_; }
    VkPipelineLayout pipeline() const { return pipeline_; }
    /// Stages that take push constants.
    VkShaderStageFlags pushedTo() const { return interface_.pushedTo; }
    /// Whose it is, for messages and debuggers.
    const char* what() const { return what_.c_str(); }

  private:
    const ShaderBinding* find(uint32_t number) const;
    void release();

    const Device* device_ = nullptr;
    VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
    VkPipelineLayout pipeline_ = VK_NULL_HANDLE;
    ShaderInterface interface_;
    std::string what_;
};

} // namespace seaglass::gpu
