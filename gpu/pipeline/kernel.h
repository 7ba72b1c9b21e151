// A compute pipeline with its layout.
#pragma once

#include <span>
#include <vector>

#include "gpu/pipeline/binding.h"

namespace seaglass::gpu {

class Kernel {
  public:
    Kernel() = default;
    ~Kernel() { release(); }
    Kernel(Kernel&& other) noexcept { *this = std::move(other); }
    Kernel& operator=(Kernel&& other) noexcept;

    /// `constants` are the specialisation constants, number 0 first.
    Status create(const Device& device, std::span<const uint32_t> spirv, const char* what,
                  std::span<const uint32_t> constants = {});

    const Layout& layout() const { return layout_; }
    /// Binds pipeline and set, then dispatches.
    void dispatch(VkCommandBuffer commands, VkDescriptorSet set, uint32_t groupsX, uint32_t groupsY,
                  uint32_t groupsZ = 1) const;
    /// A group for each 8 x 8 pixels.
    void dispatchOver(VkCommandBuffer commands, VkDescriptorSet set, VkExtent2D pixels) const;
    /// A group for each 64 invocations in a row.
    void dispatchAlong(VkCommandBuffer commands, VkDescriptorSet set, uint32_t invocations,
                       uint32_t rows = 1) const;
    /// As many groups as the VkDispatchIndirectCommand at `offset` says.
    void dispatchIndirect(VkCommandBuffer commands, VkDescriptorSet set, VkBuffer groups,
                          VkDeviceSize offset) const;

  private:
    void bind(VkCommandBuffer commands, VkDescriptorSet set) const;
    void release();

    const Device* device_ = nullptr;
    Layout layout_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// A shader module for the time it takes to build a pipeline.
class ShaderModule {
  public:
    explicit ShaderModule(const Device& device) : device_(device) {}
    ~ShaderModule() { device_.vk().DestroyShaderModule(device_.handle(), module_, device_.allocator()); }
    ShaderModule(const ShaderModule&) = delete;
    ShaderModule& operator=(const ShaderModule&) = delete;

    /// Of words that stay, as built in or as reloaded since: specialized() for `constants`.
    Status create(std::span<const uint32_t> spirv, std::span<const uint32_t> constants, const char* what);
    VkShaderModule handle() const { return module_; }
    /// What it is made of.
    std::span<const uint32_t> words() const { return words_; }

  private:
    const Device& device_;
    std::vector<uint32_t> words_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

} // namespace seaglass::gpu
