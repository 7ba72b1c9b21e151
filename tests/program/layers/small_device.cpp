// A Vulkan layer under which every device holds small pictures only: real ones hold more than the program
// asks for.
#include <cstring>

#include "tests/layer_link.h"

namespace {

constexpr uint32_t longestSide = 4096; // the least that Vulkan allows

// Of the layer below. The program makes one instance at a time.
PFN_vkGetInstanceProcAddr next = nullptr;
PFN_vkGetPhysicalDeviceProperties nextProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 nextProperties2 = nullptr;

template<class Function>
void find(VkInstance instance, const char* name, Function& out) {
    out = reinterpret_cast<Function>(next(instance, name));
}

void makeSmall(VkPhysicalDeviceLimits& limits) {
    limits.maxImageDimension2D = longestSide;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* out) {
    const auto* const link = tests::takeLink<VkLayerInstanceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    next = link->pfnNextGetInstanceProcAddr;
    PFN_vkCreateInstance create = nullptr;
    find(VK_NULL_HANDLE, "vkCreateInstance", create);
    const VkResult result = create(info, allocator, out);
    if (result != VK_SUCCESS) return result;
    // Now or never: later the loader answers with this layer's own.
    find(*out, "vkGetPhysicalDeviceProperties", nextProperties);
    find(*out, "vkGetPhysicalDeviceProperties2", nextProperties2);
    return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties* out) {
    nextProperties(device, out);
    makeSmall(out->limits);
}

VKAPI_ATTR void VKAPI_CALL properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
    nextProperties2(device, out);
    makeSmall(out->properties.limits);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL procAddr(VkInstance of, const char* name) {
    if (!std::strcmp(name, "vkGetInstanceProcAddr")) return reinterpret_cast<PFN_vkVoidFunction>(procAddr);
    if (!std::strcmp(name, "vkCreateInstance")) return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(properties);
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties2"))
        return reinterpret_cast<PFN_vkVoidFunction>(properties2);
    return next ? next(of, name) : nullptr;
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* negotiation) {
    return tests::negotiate(negotiation, procAddr, nullptr);
}
