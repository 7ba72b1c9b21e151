// What shaders read of descriptor set 0, as their SPIR-V declares it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <vulkan/vulkan_core.h>

namespace seaglass::gpu {

struct ShaderBinding {
    uint32_t number = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    VkShaderStageFlags stages = 0;
    VkFormat format = VK_FORMAT_UNDEFINED; ///< of storage images, where it is one that the libraries store to
    bool operator==(const ShaderBinding&) const = default;
};

struct ShaderInterface {
    std::vector<ShaderBinding> bindings; ///< by number
    VkShaderStageFlags pushedTo = 0;     ///< stages with push constants
};

/// Of the modules of one pipeline, one a stage. None where two of them declare a binding differently, or one
/// declares what is no uniform or storage buffer, storage image or combined image sampler.
std::optional<ShaderInterface> interfaceOf(std::span<const std::span<const uint32_t>> modules);

} // namespace seaglass::gpu
