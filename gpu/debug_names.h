// Names of objects and labels of passes, as frame debuggers and validation messages show them: by
// VK_EXT_debug_utils, where the host's instance has it enabled.
#pragma once

#include <cstdint>
#include <type_traits>

#include <vulkan/vulkan_core.h>

namespace seaglass::gpu {

class DebugNames {
  public:
    void load(VkInstance instance, PFN_vkGetInstanceProcAddr getInstanceProcAddr);

    /// "seaglass: `what`".
    template<typename Handle>
    void name(VkDevice device, VkObjectType type, Handle handle, const char* what) const {
        if (!setName_) return;
        if constexpr (std::is_pointer_v<Handle>)
            nameBits(device, type, reinterpret_cast<uintptr_t>(handle), what);
        else
            nameBits(device, type, handle, what);
    }

    void beginPass(VkCommandBuffer commands, const char* pass) const;
    void endPass(VkCommandBuffer commands) const;

  private:
    void nameBits(VkDevice device, VkObjectType type, uint64_t handle, const char* what) const;

    PFN_vkSetDebugUtilsObjectNameEXT setName_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT endLabel_ = nullptr;
};

} // namespace seaglass::gpu
