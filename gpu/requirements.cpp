#include "gpu/requirements.h"

#include <cstdio>

namespace seaglass {

namespace {

struct FormatNeed {
    VkFormat format;
    VkFormatFeatureFlags features;
    const char* name;
};

// Wave maps are 32-bit: a half steps 4 mm at a height of 4 m.
constexpr FormatNeed formatNeeds[] = {
    {VK_FORMAT_R32G32B32A32_SFLOAT,
     VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT | VK_FORMAT_FEATURE_BLIT_SRC_BIT |
         VK_FORMAT_FEATURE_BLIT_DST_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT,
     "linear filtering and blits of R32G32B32A32_SFLOAT"},
    {VK_FORMAT_R16G16B16A16_SFLOAT,
     VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT,
     "storage images of R16G16B16A16_SFLOAT"},
    {VK_FORMAT_R16_SFLOAT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT,
     "storage images of R16_SFLOAT"},
};

} // namespace

bool gpu::supported(const InstanceTable& vk, VkPhysicalDevice physicalDevice, char* text, size_t size) {
    VkPhysicalDeviceProperties properties{};
    vk.GetPhysicalDeviceProperties(physicalDevice, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_3) {
        std::snprintf(text, size, "%s has Vulkan %u.%u, expected 1.3 or later", properties.deviceName,
                      VK_API_VERSION_MAJOR(properties.apiVersion),
                      VK_API_VERSION_MINOR(properties.apiVersion));
        return false;
    }
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    features.pNext = &features13;
    vk.GetPhysicalDeviceFeatures2(physicalDevice, &features);
    const char* missing = nullptr;
    if (!features13.synchronization2) missing = "the feature synchronization2";
    if (!features13.shaderDemoteToHelperInvocation) missing = "the feature shaderDemoteToHelperInvocation";
    if (!features.features.shaderStorageImageExtendedFormats)
        missing = "the feature shaderStorageImageExtendedFormats";
    for (const FormatNeed& need : formatNeeds) {
        VkFormatProperties format{};
        vk.GetPhysicalDeviceFormatProperties(physicalDevice, need.format, &format);
        if ((format.optimalTilingFeatures & need.features) != need.features) missing = need.name;
    }
    if (missing) std::snprintf(text, size, "%s lacks %s", properties.deviceName, missing);
    return !missing;
}

Requirements requirements() {
    Requirements out;
    out.apiVersion = VK_API_VERSION_1_3;
    out.features.shaderStorageImageExtendedFormats = VK_TRUE;
#ifdef SEAGLASS_HOSTILE_ARITHMETIC
    out.features.shaderFloat64 = VK_TRUE; // in which a fused multiply-add is made
#endif
    out.features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    out.features13.synchronization2 = VK_TRUE;
    out.features13.shaderDemoteToHelperInvocation = VK_TRUE;
    return out;
}

Status checkSupport(VkInstance instance, VkPhysicalDevice physicalDevice,
                    PFN_vkGetInstanceProcAddr getInstanceProcAddr, MessageCallback message) {
    const auto say = [&](const char* text) {
        if (message.function) message.function(message.user, text);
    };
    if (!instance || !physicalDevice || !getInstanceProcAddr) {
        say("checkSupport: instance, physicalDevice and getInstanceProcAddr must not be null");
        return Status::invalidArgument;
    }
    gpu::InstanceTable vk;
    char text[512];
    if (const char* missing = gpu::load(vk, instance, getInstanceProcAddr)) {
        std::snprintf(text, sizeof text, "the Vulkan loader has no %s", missing);
        say(text);
        return Status::unsupported;
    }
    if (gpu::supported(vk, physicalDevice, text, sizeof text)) return Status::ok;
    say(text);
    return Status::unsupported;
}

} // namespace seaglass
