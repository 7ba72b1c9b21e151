// A Vulkan layer whose device goes wrong once a file is there: it takes no timestamp of that command buffer
// from a certain one on, as if it had stopped in the pass before it. SEAGLASS_LOST_HOW says what waiting for
// it comes to: `lost`; `mute`, lost and its queries cannot be read; `hung`, it has not come back; or `later`,
// it has not come back and is mute in the end. From then on whoever waits without a limit or destroys it is
// ended. SEAGLASS_NO_IMAGE: no image of a window is free. SEAGLASS_SLOW_DRIVER: the first compute pipeline
// takes eleven seconds.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <thread>

#include "tests/layer_link.h"

namespace {

// Of the layer below. The program makes one instance and one device at a time, and submits from one thread.
PFN_vkGetInstanceProcAddr next = nullptr;
PFN_vkGetDeviceProcAddr nextOfDevice = nullptr;
VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;

struct State {
    bool stops = false, stopped = false, mute = false, slept = false;
    uint32_t timestamps = 0; ///< of the command buffer
    uint64_t waitedNs = 0;   ///< for one that has stopped
} state;

constexpr uint64_t nsInS = 1'000'000'000;
constexpr uint64_t longestNs = 4000 * nsInS; ///< that the program should ever wait
constexpr uint64_t lostAfterNs = 2 * nsInS;  ///< where it is lost later

const char* setting(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

template<class Function>
Function below(const char* name) {
    return reinterpret_cast<Function>(nextOfDevice(device, name));
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* out) {
    const auto* const link = tests::takeLink<VkLayerInstanceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    next = link->pfnNextGetInstanceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, out);
    if (result == VK_SUCCESS) instance = *out;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* out) {
    const auto* const link =
        tests::takeLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    const PFN_vkGetInstanceProcAddr ofInstance = link->pfnNextGetInstanceProcAddr;
    nextOfDevice = link->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(ofInstance(instance, "vkCreateDevice"));
    const VkResult result = create(physical, info, allocator, out);
    if (result == VK_SUCCESS) device = *out;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL beginCommands(VkCommandBuffer commands, const VkCommandBufferBeginInfo* info) {
    state.timestamps = 0;
    const char* const once = setting("SEAGLASS_LOST_ONCE");
    state.stops = *once && std::filesystem::exists(once);
    return below<PFN_vkBeginCommandBuffer>("vkBeginCommandBuffer")(commands, info);
}

VKAPI_ATTR void VKAPI_CALL writeTimestamp(VkCommandBuffer commands, VkPipelineStageFlags2 stage,
                                          VkQueryPool pool, uint32_t query) {
    if (state.stops && state.timestamps++ >= std::strtoul(setting("SEAGLASS_LOST_AFTER"), nullptr, 10))
        return;
    below<PFN_vkCmdWriteTimestamp2>("vkCmdWriteTimestamp2")(commands, stage, pool, query);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice of, uint32_t count, const VkFence* fences, VkBool32 all,
                                             uint64_t timeout) {
    // What was submitted before it is awaited whole.
    if (!state.stopped) {
        const VkResult result =
            below<PFN_vkWaitForFences>("vkWaitForFences")(of, count, fences, all, UINT64_MAX);
        if (!state.stops || state.timestamps == 0) return result;
    }
    state.stopped = true;
    const std::string_view how = setting("SEAGLASS_LOST_HOW");
    if (state.mute || timeout > longestNs - state.waitedNs) std::abort();
    state.waitedNs += timeout;
    if (how == "hung" || (how == "later" && state.waitedNs < lostAfterNs)) return VK_TIMEOUT;
    state.mute = how != "lost";
    return VK_ERROR_DEVICE_LOST;
}

VKAPI_ATTR VkResult VKAPI_CALL getResults(VkDevice of, VkQueryPool pool, uint32_t first, uint32_t count,
                                          size_t size, void* data, VkDeviceSize stride,
                                          VkQueryResultFlags flags) {
    if (state.mute) return VK_ERROR_DEVICE_LOST;
    return below<PFN_vkGetQueryPoolResults>("vkGetQueryPoolResults")(of, pool, first, count, size, data,
                                                                     stride, flags);
}

VKAPI_ATTR VkResult VKAPI_CALL acquireImage(VkDevice of, VkSwapchainKHR swapchain, uint64_t timeout,
                                            VkSemaphore semaphore, VkFence fence, uint32_t* image) {
    if (state.stopped || (*setting("SEAGLASS_NO_IMAGE") && timeout > longestNs)) std::abort();
    if (*setting("SEAGLASS_NO_IMAGE")) return VK_TIMEOUT;
    return below<PFN_vkAcquireNextImageKHR>("vkAcquireNextImageKHR")(of, swapchain, timeout, semaphore, fence,
                                                                     image);
}

VKAPI_ATTR VkResult VKAPI_CALL waitIdle(VkDevice of) {
    if (state.stopped) std::abort();
    return below<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(of);
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice of, const VkAllocationCallbacks* allocator) {
    if (state.stopped) std::abort();
    below<PFN_vkDestroyDevice>("vkDestroyDevice")(of, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL createCompute(VkDevice of, VkPipelineCache cache, uint32_t count,
                                             const VkComputePipelineCreateInfo* infos,
                                             const VkAllocationCallbacks* allocator, VkPipeline* out) {
    if (!state.slept && *setting("SEAGLASS_SLOW_DRIVER"))
        std::this_thread::sleep_for(std::chrono::seconds(11));
    state.slept = true;
    return below<PFN_vkCreateComputePipelines>("vkCreateComputePipelines")(of, cache, count, infos, allocator,
                                                                           out);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice of, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL procAddr(VkInstance of, const char* name);

struct Own {
    const char* name;
    PFN_vkVoidFunction function;
};

template<class Function>
Own own(const char* name, Function function) {
    return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

PFN_vkVoidFunction ownFunction(const char* name) {
    static const Own all[] = {
        own("vkGetInstanceProcAddr", procAddr),     own("vkGetDeviceProcAddr", deviceProcAddr),
        own("vkCreateInstance", createInstance),    own("vkCreateDevice", createDevice),
        own("vkBeginCommandBuffer", beginCommands), own("vkCmdWriteTimestamp2", writeTimestamp),
        own("vkWaitForFences", waitForFences),      own("vkDeviceWaitIdle", waitIdle),
        own("vkDestroyDevice", destroyDevice),      own("vkCreateComputePipelines", createCompute),
        own("vkGetQueryPoolResults", getResults),   own("vkAcquireNextImageKHR", acquireImage)};
    const auto* const found = std::find_if(std::begin(all), std::end(all),
                                           [&](const Own& one) { return !std::strcmp(one.name, name); });
    return found == std::end(all) ? nullptr : found->function;
}

PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice of, const char* name) {
    const PFN_vkVoidFunction mine = ownFunction(name);
    return mine || !nextOfDevice ? mine : nextOfDevice(of, name);
}

PFN_vkVoidFunction VKAPI_CALL procAddr(VkInstance of, const char* name) {
    const PFN_vkVoidFunction mine = ownFunction(name);
    return mine || !next ? mine : next(of, name);
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* negotiation) {
    return tests::negotiate(negotiation, procAddr, deviceProcAddr);
}
