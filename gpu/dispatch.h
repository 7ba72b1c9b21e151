// Vulkan entry points, loaded for one device from the host's own loader.
//
// volk would serve, but it keeps its table in global symbols named like Vulkan's own: two hosts in one
// process would share it, and a host that links the loader would clash with it.
#pragma once

#include <vulkan/vulkan_core.h>

#define SEAGLASS_INSTANCE_FUNCTIONS(X)                                                                       \
    X(GetPhysicalDeviceProperties)                                                                           \
    X(GetPhysicalDeviceFeatures2)                                                                            \
    X(GetPhysicalDeviceMemoryProperties)                                                                     \
    X(GetPhysicalDeviceFormatProperties)

#define SEAGLASS_DEVICE_FUNCTIONS(X)                                                                         \
    X(AllocateDescriptorSets)                                                                                \
    X(AllocateMemory)                                                                                        \
    X(BindBufferMemory)                                                                                      \
    X(BindImageMemory)                                                                                       \
    X(CmdBeginRenderPass)                                                                                    \
    X(CmdBindDescriptorSets)                                                                                 \
    X(CmdBindIndexBuffer)                                                                                    \
    X(CmdBindPipeline)                                                                                       \
    X(CmdBlitImage)                                                                                          \
    X(CmdClearColorImage)                                                                                    \
    X(CmdCopyBuffer)                                                                                         \
    X(CmdCopyBufferToImage)                                                                                  \
    X(CmdCopyImage)                                                                                          \
    X(CmdDispatch)                                                                                           \
    X(CmdDispatchIndirect)                                                                                   \
    X(CmdDraw)                                                                                               \
    X(CmdDrawIndexed)                                                                                        \
    X(CmdEndRenderPass)                                                                                      \
    X(CmdFillBuffer)                                                                                         \
    X(CmdPipelineBarrier2)                                                                                   \
    X(CmdPushConstants)                                                                                      \
    X(CmdSetScissor)                                                                                         \
    X(CmdSetViewport)                                                                                        \
    X(CreateBuffer)                                                                                          \
    X(CreateComputePipelines)                                                                                \
    X(CreateDescriptorPool)                                                                                  \
    X(CreateDescriptorSetLayout)                                                                             \
    X(CreateFramebuffer)                                                                                     \
    X(CreateGraphicsPipelines)                                                                               \
    X(CreateImage)                                                                                           \
    X(CreateImageView)                                                                                       \
    X(CreatePipelineLayout)                                                                                  \
    X(CreateRenderPass)                                                                                      \
    X(CreateSampler)                                                                                         \
    X(CreateShaderModule)                                                                                    \
    X(DestroyBuffer)                                                                                         \
    X(DestroyDescriptorPool)                                                                                 \
    X(DestroyDescriptorSetLayout)                                                                            \
    X(DestroyFramebuffer)                                                                                    \
    X(DestroyImage)                                                                                          \
    X(DestroyImageView)                                                                                      \
    X(DestroyPipeline)                                                                                       \
    X(DestroyPipelineLayout)                                                                                 \
    X(DestroyRenderPass)                                                                                     \
    X(DestroySampler)                                                                                        \
    X(DestroyShaderModule)                                                                                   \
    X(FreeMemory)                                                                                            \
    X(GetBufferMemoryRequirements)                                                                           \
    X(GetDeviceBufferMemoryRequirements)                                                                     \
    X(GetDeviceImageMemoryRequirements)                                                                      \
    X(GetImageMemoryRequirements)                                                                            \
    X(MapMemory)                                                                                             \
    X(ResetDescriptorPool)                                                                                   \
    X(UpdateDescriptorSets)

namespace seaglass::gpu {

#define SEAGLASS_DECLARE(name) PFN_vk##name name = nullptr;

struct InstanceTable {
    SEAGLASS_INSTANCE_FUNCTIONS(SEAGLASS_DECLARE)
    PFN_vkGetDeviceProcAddr GetDeviceProcAddr = nullptr;
};

struct DeviceTable {
    SEAGLASS_DEVICE_FUNCTIONS(SEAGLASS_DECLARE)
};

#undef SEAGLASS_DECLARE

/// Null when every function was found, else the name of the first that was not.
const char* load(InstanceTable& table, VkInstance instance, PFN_vkGetInstanceProcAddr getInstanceProcAddr);
const char* load(DeviceTable& table, VkDevice device, PFN_vkGetDeviceProcAddr getDeviceProcAddr);

} // namespace seaglass::gpu
