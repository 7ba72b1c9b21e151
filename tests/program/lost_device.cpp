// A Vulkan layer whose device goes wrong once a file is there: it takes no timestamp of that command buffer
// from a certain one on, as if it had stopped in the pass before it, and waiting for it says that it is lost
// or has not come back. From then on whoever waits for it or destroys it is ended. Or its driver takes eleven
// seconds for the first compute pipeline.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "tests/layer_link.h"

namespace {

// Of the layer below. The program makes one instance and one device at a time, and submits from one thread.
PFN_vkGetInstanceProcAddr next = nullptr;
PFN_vkGetDeviceProcAddr nextOfDevice = nullptr;
VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;

struct State {
    bool stops = false, stopped = false, slept = false;
    uint32_t timestamps = 0; ///< of the command buffer
} state;

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
    if (state.stopped) std::abort();
    const VkResult result = below<PFN_vkWaitForFences>("vkWaitForFences")(of, count, fences, all, timeout);
    if (!state.stops || state.timestamps == 0) return result;
    state.stopped = true;
    return std::strcmp(setting("SEAGLASS_LOST_HOW"), "hung") ? VK_ERROR_DEVICE_LOST : VK_TIMEOUT;
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
        own("vkDestroyDevice", destroyDevice),      own("vkCreateComputePipelines", createCompute)};
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
