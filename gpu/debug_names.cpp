#include "gpu/debug_names.h"

#include <cstdio>

namespace seaglass::gpu {

void DebugNames::load(VkInstance instance, PFN_vkGetInstanceProcAddr getInstanceProcAddr) {
    // The loader has none of them for an instance without the extension.
    setName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
        getInstanceProcAddr(instance, "vkSetDebugUtilsObjectNameEXT"));
    beginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
        getInstanceProcAddr(instance, "vkCmdBeginDebugUtilsLabelEXT"));
    endLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
        getInstanceProcAddr(instance, "vkCmdEndDebugUtilsLabelEXT"));
}

void DebugNames::nameBits(VkDevice device, VkObjectType type, uint64_t handle, const char* what) const {
    char text[128];
    std::snprintf(text, sizeof text, "seaglass: %s", what);
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text;
    // A name that could not be kept is no reason to stop.
    static_cast<void>(setName_(device, &info));
}

void DebugNames::beginPass(VkCommandBuffer commands, const char* pass) const {
    if (!beginLabel_ || !endLabel_) return;
    char text[128];
    std::snprintf(text, sizeof text, "seaglass: %s", pass);
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = text;
    beginLabel_(commands, &label);
}

void DebugNames::endPass(VkCommandBuffer commands) const {
    if (beginLabel_ && endLabel_) endLabel_(commands);
}

} // namespace seaglass::gpu
