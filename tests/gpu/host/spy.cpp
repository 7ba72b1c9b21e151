#include "tests/gpu/host/spy.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

namespace tests {

std::vector<SpiedCall>& spiedCalls() {
    static std::vector<SpiedCall> calls;
    return calls;
}

size_t countSpied(const std::string& name) {
    return static_cast<size_t>(
        std::ranges::count_if(spiedCalls(), [&](const SpiedCall& call) { return call.name == name; }));
}

VkDeviceSize bytesSpied() {
    VkDeviceSize sum = 0;
    for (const SpiedCall& call : spiedCalls()) sum += call.bytes;
    return sum;
}

namespace {

/// Pipelines are made on several threads.
std::mutex& spying() {
    static std::mutex mutex;
    return mutex;
}

void note(SpiedCall call) {
    const std::lock_guard lock(spying());
    spiedCalls().push_back(std::move(call));
}

/// Forwards to the function that volk loaded under the same name.
template<auto* real, class Result, class... Arguments>
struct Spy {
    static inline const char* name = nullptr;
    static Result VKAPI_CALL call(Arguments... arguments) {
        note({name});
        return (*real)(arguments...);
    }
};

template<auto* real, class Result, class... Arguments>
PFN_vkVoidFunction spyOn(const char* name, Result(VKAPI_PTR*)(Arguments...)) {
    using Watched = Spy<real, Result, Arguments...>;
    Watched::name = name;
    return reinterpret_cast<PFN_vkVoidFunction>(&Watched::call);
}

void VKAPI_CALL spiedBarrier(VkCommandBuffer commands, const VkDependencyInfo* info) {
    SpiedCall call{"CmdPipelineBarrier2"};
    const auto add = [&](const auto* barriers, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            call.source |= barriers[i].srcAccessMask;
            call.target |= barriers[i].dstAccessMask;
        }
    };
    add(info->pMemoryBarriers, info->memoryBarrierCount);
    add(info->pBufferMemoryBarriers, info->bufferMemoryBarrierCount);
    add(info->pImageMemoryBarriers, info->imageMemoryBarrierCount);
    note(call);
    vkCmdPipelineBarrier2(commands, info);
}

VkResult VKAPI_CALL spiedAllocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                  const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
    SpiedCall call{"AllocateMemory"};
    call.bytes = info->allocationSize;
    note(call);
    return vkAllocateMemory(device, info, allocator, memory);
}

/// Handles come again: of each what it was made of last.
std::map<VkShaderModule, std::vector<uint32_t>>& modules() {
    static std::map<VkShaderModule, std::vector<uint32_t>> made;
    return made;
}

SpiedStage spiedStage(const VkPipelineShaderStageCreateInfo& info) {
    const std::lock_guard lock(spying());
    SpiedStage stage{modules().at(info.module), {}};
    if (const VkSpecializationInfo* const constants = info.pSpecializationInfo) {
        const auto* const words = static_cast<const uint32_t*>(constants->pData);
        stage.constants.assign(words, words + constants->dataSize / sizeof(uint32_t));
    }
    return stage;
}

VkResult VKAPI_CALL spiedShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                      const VkAllocationCallbacks* allocator, VkShaderModule* module) {
    SpiedCall call{"CreateShaderModule"};
    call.spirv.assign(info->pCode, info->pCode + info->codeSize / sizeof(uint32_t));
    const VkResult result = vkCreateShaderModule(device, info, allocator, module);
    if (result == VK_SUCCESS) {
        const std::lock_guard lock(spying());
        modules()[*module] = call.spirv;
    }
    note(std::move(call));
    return result;
}

VkResult VKAPI_CALL spiedGraphics(VkDevice device, VkPipelineCache cache, uint32_t count,
                                  const VkGraphicsPipelineCreateInfo* infos,
                                  const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    SpiedCall call{"CreateGraphicsPipelines"};
    call.cache = cache;
    for (uint32_t i = 0; i < infos->stageCount; ++i) call.stages.push_back(spiedStage(infos->pStages[i]));
    call.constants = call.stages.back().constants;
    call.writesDepth = infos->pDepthStencilState->depthWriteEnable;
    note(std::move(call));
    return vkCreateGraphicsPipelines(device, cache, count, infos, allocator, pipelines);
}

VkResult VKAPI_CALL spiedCompute(VkDevice device, VkPipelineCache cache, uint32_t count,
                                 const VkComputePipelineCreateInfo* infos,
                                 const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    SpiedCall call{"CreateComputePipelines"};
    call.cache = cache;
    call.stages.push_back(spiedStage(infos->stage));
    call.constants = call.stages.back().constants;
    note(std::move(call));
    return vkCreateComputePipelines(device, cache, count, infos, allocator, pipelines);
}

VkResult VKAPI_CALL spiedSetLayout(VkDevice device, const VkDescriptorSetLayoutCreateInfo* info,
                                   const VkAllocationCallbacks* allocator, VkDescriptorSetLayout* layout) {
    SpiedCall call{"CreateDescriptorSetLayout"};
    for (uint32_t i = 0; i < info->bindingCount; ++i)
        call.sampled += info->pBindings[i].descriptorType == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    note(call);
    return vkCreateDescriptorSetLayout(device, info, allocator, layout);
}

VkPhysicalDeviceType pretendedType = VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM;

void VKAPI_CALL pretendedProperties(VkPhysicalDevice device, VkPhysicalDeviceProperties* properties) {
    vkGetPhysicalDeviceProperties(device, properties);
    if (pretendedType != VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM) properties->deviceType = pretendedType;
}

VkDeviceSize pretendedAlignment = 0;

void pretend(VkMemoryRequirements& needs) {
    if (pretendedAlignment == 0) return;
    needs.alignment = std::max(needs.alignment, pretendedAlignment);
    needs.size = (needs.size + pretendedAlignment - 1) / pretendedAlignment * pretendedAlignment;
}

void VKAPI_CALL pretendedImageNeeds(VkDevice device, VkImage image, VkMemoryRequirements* needs) {
    vkGetImageMemoryRequirements(device, image, needs);
    pretend(*needs);
}

void VKAPI_CALL pretendedBufferNeeds(VkDevice device, VkBuffer buffer, VkMemoryRequirements* needs) {
    vkGetBufferMemoryRequirements(device, buffer, needs);
    pretend(*needs);
}

void VKAPI_CALL pretendedImageNeedsBefore(VkDevice device, const VkDeviceImageMemoryRequirements* info,
                                          VkMemoryRequirements2* needs) {
    vkGetDeviceImageMemoryRequirements(device, info, needs);
    pretend(needs->memoryRequirements);
}

void VKAPI_CALL pretendedBufferNeedsBefore(VkDevice device, const VkDeviceBufferMemoryRequirements* info,
                                           VkMemoryRequirements2* needs) {
    vkGetDeviceBufferMemoryRequirements(device, info, needs);
    pretend(needs->memoryRequirements);
}

PFN_vkVoidFunction VKAPI_CALL spiedGetDeviceProcAddr(VkDevice device, const char* name) {
    if (!std::strcmp(name, "vkCmdPipelineBarrier2"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedBarrier);
    if (!std::strcmp(name, "vkCreateShaderModule"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedShaderModule);
    if (!std::strcmp(name, "vkAllocateMemory")) return reinterpret_cast<PFN_vkVoidFunction>(&spiedAllocate);
    if (!std::strcmp(name, "vkCreateGraphicsPipelines"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedGraphics);
    if (!std::strcmp(name, "vkCreateComputePipelines"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedCompute);
    if (!std::strcmp(name, "vkCreateDescriptorSetLayout"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedSetLayout);
#define PRETEND(function, by)                                                                                \
    if (!std::strcmp(name, "vk" #function)) return reinterpret_cast<PFN_vkVoidFunction>(&by);
    PRETEND(GetImageMemoryRequirements, pretendedImageNeeds)
    PRETEND(GetBufferMemoryRequirements, pretendedBufferNeeds)
    PRETEND(GetDeviceImageMemoryRequirements, pretendedImageNeedsBefore)
    PRETEND(GetDeviceBufferMemoryRequirements, pretendedBufferNeedsBefore)
#undef PRETEND
#define SPY(function)                                                                                        \
    if (!std::strcmp(name, "vk" #function)) return spyOn<&vk##function>(#function, vk##function);
    SPY(AllocateDescriptorSets)
    SPY(CmdBlitImage)
    SPY(CmdClearColorImage)
    SPY(CmdCopyBuffer)
    SPY(CmdCopyBufferToImage)
    SPY(CmdDispatch)
    SPY(CmdDispatchIndirect)
    SPY(CmdDraw)
    SPY(CmdDrawIndexed)
    SPY(CmdFillBuffer)
    SPY(CreateBuffer)
    SPY(CreateImage)
#undef SPY
    return vkGetDeviceProcAddr(device, name);
}

} // namespace

void pretendDeviceType(VkPhysicalDeviceType type) {
    pretendedType = type;
}

void pretendAlignment(VkDeviceSize bytes) {
    pretendedAlignment = bytes;
}

PFN_vkVoidFunction VKAPI_CALL spiedGetInstanceProcAddr(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&spiedGetDeviceProcAddr);
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(&pretendedProperties);
    return vkGetInstanceProcAddr(instance, name);
}

} // namespace tests
