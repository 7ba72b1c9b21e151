// Listens to what the library asks of Vulkan, by standing between it and the loader: what it creates, and in
// which order it records. Validation cannot see everything: it takes an atomic in a shader for a read.
#pragma once

#include <string>
#include <vector>

#include <volk.h>

namespace tests {

/// Of a pipeline.
struct SpiedStage {
    std::vector<uint32_t> spirv;
    std::vector<uint32_t> constants; ///< words from number 0 on
};

struct SpiedCall {
    std::string name;          ///< without "vk"
    VkAccessFlags2 source = 0; ///< of a barrier: all its source accesses together
    VkAccessFlags2 target = 0;
    VkDeviceSize bytes = 0;                 ///< of an allocation
    std::vector<uint32_t> spirv;            ///< of a shader module
    VkPipelineCache cache = VK_NULL_HANDLE; ///< of pipelines
    uint32_t sampled = 0;                   ///< images that shaders of a descriptor set layout sample
    std::vector<uint32_t> constants;        ///< of a graphics pipeline's last stage, words from number 0 on
    std::vector<SpiedStage> stages;         ///< of a pipeline
    bool writesDepth = false;               ///< of a graphics pipeline
};

/// The calls since clear(), of all threads; read while only one calls. One list for the program: tests run
/// one at a time.
std::vector<SpiedCall>& spiedCalls();
size_t countSpied(const std::string& name);
/// Device memory asked for.
VkDeviceSize bytesSpied();

/// What contexts are told that the device is; VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM, as at first, for the truth.
void pretendDeviceType(VkPhysicalDeviceType type);

/// All that wants memory is told to want whole multiples of `bytes`, aligned so; 0, as at first, for the
/// truth.
void pretendAlignment(VkDeviceSize bytes);

/// To be handed to a context as its loader.
PFN_vkVoidFunction VKAPI_CALL spiedGetInstanceProcAddr(VkInstance instance, const char* name);

} // namespace tests
