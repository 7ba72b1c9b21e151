// What every Vulkan layer of the tests says to the loader, and takes of it.
#pragma once

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace tests {

/// The layer below, by the loader's own struct in `chain`, which is moved on for the one below that; null
/// where there is none. `Info` is VkLayerInstanceCreateInfo or VkLayerDeviceCreateInfo, `type` its sType.
template<typename Info>
auto takeLink(const void* chain, VkStructureType type) {
    const auto* info = static_cast<const Info*>(chain);
    while (info && (info->sType != type || info->function != VK_LAYER_LINK_INFO))
        info = static_cast<const Info*>(info->pNext);
    auto* const link = info ? info->u.pLayerInfo : nullptr;
    if (link) const_cast<Info*>(info)->u.pLayerInfo = link->pNext;
    return link;
}

/// Answers vkNegotiateLoaderLayerInterfaceVersion. `ofDevice` is null where the layer changes no device's
/// calls.
inline VkResult negotiate(VkNegotiateLayerInterface* negotiation, PFN_vkGetInstanceProcAddr ofInstance,
                          PFN_vkGetDeviceProcAddr ofDevice) {
    negotiation->loaderLayerInterfaceVersion = 2;
    negotiation->pfnGetInstanceProcAddr = ofInstance;
    negotiation->pfnGetDeviceProcAddr = ofDevice;
    negotiation->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}

} // namespace tests
