#include "tests/null/compiled_twice.h"

#include <algorithm>
#include <cstring>
#include <map>

#include "tests/null/built_shaders.h"

namespace tests {

namespace {

struct Module {
    VkShaderModule twin = VK_NULL_HANDLE;
    std::string shader;
    size_t bytes = 0;
};

/// What was made on the null device, by the library's own handles.
struct Twins {
    const NullDevice* device = nullptr;
    std::map<VkShaderModule, Module> modules;
    std::map<VkDescriptorSetLayout, VkDescriptorSetLayout> setLayouts;
    std::map<VkPipelineLayout, VkPipelineLayout> pipelineLayouts;
};

Twins& twins() {
    static Twins all;
    return all;
}

VkResult VKAPI_CALL createModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                 const VkAllocationCallbacks* allocator, VkShaderModule* out) {
    const VkResult result = vkCreateShaderModule(device, info, allocator, out);
    if (!twins().device || result != VK_SUCCESS) return result;
    Module& module = twins().modules[*out];
    module.shader = builtShaderName({info->pCode, info->codeSize / sizeof(uint32_t)});
    module.bytes = info->codeSize;
    const NullDevice& null = *twins().device;
    return null.vk().vkCreateShaderModule(null.handle(), info, nullptr, &module.twin);
}

VkResult VKAPI_CALL createSetLayout(VkDevice device, const VkDescriptorSetLayoutCreateInfo* info,
                                    const VkAllocationCallbacks* allocator, VkDescriptorSetLayout* out) {
    const VkResult result = vkCreateDescriptorSetLayout(device, info, allocator, out);
    if (!twins().device || result != VK_SUCCESS) return result;
    const NullDevice& null = *twins().device;
    return null.vk().vkCreateDescriptorSetLayout(null.handle(), info, nullptr, &twins().setLayouts[*out]);
}

VkResult VKAPI_CALL createPipelineLayout(VkDevice device, const VkPipelineLayoutCreateInfo* info,
                                         const VkAllocationCallbacks* allocator, VkPipelineLayout* out) {
    const VkResult result = vkCreatePipelineLayout(device, info, allocator, out);
    if (!twins().device || result != VK_SUCCESS) return result;
    std::vector<VkDescriptorSetLayout> sets;
    for (uint32_t i = 0; i < info->setLayoutCount; ++i)
        sets.push_back(twins().setLayouts.at(info->pSetLayouts[i]));
    VkPipelineLayoutCreateInfo twin = *info;
    twin.pSetLayouts = sets.data();
    const NullDevice& null = *twins().device;
    return null.vk().vkCreatePipelineLayout(null.handle(), &twin, nullptr, &twins().pipelineLayouts[*out]);
}

VkPipelineShaderStageCreateInfo twinOf(const VkPipelineShaderStageCreateInfo& info) {
    VkPipelineShaderStageCreateInfo twin = info;
    twin.module = twins().modules.at(info.module).twin;
    return twin;
}

CompiledStage described(const VkPipelineShaderStageCreateInfo& info, const std::vector<StageCosts>& costs) {
    const Module& module = twins().modules.at(info.module);
    CompiledStage stage{module.shader, {}, module.bytes, {}};
    if (const VkSpecializationInfo* const constants = info.pSpecializationInfo) {
        stage.constants.resize(constants->dataSize / sizeof(uint32_t));
        std::memcpy(stage.constants.data(), constants->pData, constants->dataSize);
    }
    const auto found = std::ranges::find_if(costs, [&](const StageCosts& each) {
        return (each.stages & static_cast<uint32_t>(info.stage)) != 0;
    });
    if (found != costs.end()) stage.costs = *found;
    return stage;
}

/// Keeps what a pipeline of the null device takes, and destroys it.
void keep(VkResult result, VkPipeline pipeline, const VkPipelineShaderStageCreateInfo* stages,
          uint32_t count) {
    const NullDevice& null = *twins().device;
    CompiledPipeline compiled;
    compiled.result = result;
    const std::vector<StageCosts> costs =
        result == VK_SUCCESS ? costsOf(null, pipeline) : std::vector<StageCosts>();
    for (uint32_t i = 0; i < count; ++i) compiled.stages.push_back(described(stages[i], costs));
    compiledPipelines().push_back(std::move(compiled));
    null.vk().vkDestroyPipeline(null.handle(), pipeline, nullptr);
}

VkResult VKAPI_CALL createCompute(VkDevice device, VkPipelineCache cache, uint32_t count,
                                  const VkComputePipelineCreateInfo* infos,
                                  const VkAllocationCallbacks* allocator, VkPipeline* out) {
    for (uint32_t i = 0; twins().device && i < count; ++i) {
        VkComputePipelineCreateInfo twin = infos[i];
        twin.flags |= VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
        twin.stage = twinOf(infos[i].stage);
        twin.layout = twins().pipelineLayouts.at(infos[i].layout);
        const NullDevice& null = *twins().device;
        VkPipeline pipeline = VK_NULL_HANDLE;
        const VkResult result =
            null.vk().vkCreateComputePipelines(null.handle(), VK_NULL_HANDLE, 1, &twin, nullptr, &pipeline);
        keep(result, pipeline, &infos[i].stage, 1);
    }
    return vkCreateComputePipelines(device, cache, count, infos, allocator, out);
}

VkResult VKAPI_CALL createGraphics(VkDevice device, VkPipelineCache cache, uint32_t count,
                                   const VkGraphicsPipelineCreateInfo* infos,
                                   const VkAllocationCallbacks* allocator, VkPipeline* out) {
    for (uint32_t i = 0; twins().device && i < count; ++i) {
        VkGraphicsPipelineCreateInfo twin = infos[i];
        twin.flags |= VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
        std::vector<VkPipelineShaderStageCreateInfo> stages;
        for (uint32_t s = 0; s < infos[i].stageCount; ++s) stages.push_back(twinOf(infos[i].pStages[s]));
        twin.pStages = stages.data();
        twin.layout = twins().pipelineLayouts.at(infos[i].layout);
        const NullDevice& null = *twins().device;
        VkPipeline pipeline = VK_NULL_HANDLE;
        const VkResult result =
            null.vk().vkCreateGraphicsPipelines(null.handle(), VK_NULL_HANDLE, 1, &twin, nullptr, &pipeline);
        keep(result, pipeline, infos[i].pStages, infos[i].stageCount);
    }
    return vkCreateGraphicsPipelines(device, cache, count, infos, allocator, out);
}

/// Forgets the twin of `handle` and gives it back, or a null handle.
template<typename Handle, typename Twin>
Twin taken(std::map<Handle, Twin>& made, Handle handle) {
    const auto node = made.extract(handle);
    return node ? node.mapped() : Twin{};
}

void VKAPI_CALL destroyModule(VkDevice device, VkShaderModule module,
                              const VkAllocationCallbacks* allocator) {
    vkDestroyShaderModule(device, module, allocator);
    const VkShaderModule twin = taken(twins().modules, module).twin;
    if (const NullDevice* const null = twins().device)
        null->vk().vkDestroyShaderModule(null->handle(), twin, nullptr);
}

void VKAPI_CALL destroySetLayout(VkDevice device, VkDescriptorSetLayout layout,
                                 const VkAllocationCallbacks* allocator) {
    vkDestroyDescriptorSetLayout(device, layout, allocator);
    const VkDescriptorSetLayout twin = taken(twins().setLayouts, layout);
    if (const NullDevice* const null = twins().device)
        null->vk().vkDestroyDescriptorSetLayout(null->handle(), twin, nullptr);
}

void VKAPI_CALL destroyPipelineLayout(VkDevice device, VkPipelineLayout layout,
                                      const VkAllocationCallbacks* allocator) {
    vkDestroyPipelineLayout(device, layout, allocator);
    const VkPipelineLayout twin = taken(twins().pipelineLayouts, layout);
    if (const NullDevice* const null = twins().device)
        null->vk().vkDestroyPipelineLayout(null->handle(), twin, nullptr);
}

void VKAPI_CALL twinsProperties(VkPhysicalDevice device, VkPhysicalDeviceProperties* properties) {
    vkGetPhysicalDeviceProperties(device, properties);
    if (twins().device) properties->deviceType = twins().device->type();
}

PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
#define TWICE(function, replacement)                                                                         \
    if (!std::strcmp(name, #function)) return reinterpret_cast<PFN_vkVoidFunction>(&replacement);
    TWICE(vkCreateShaderModule, createModule)
    TWICE(vkCreateDescriptorSetLayout, createSetLayout)
    TWICE(vkCreatePipelineLayout, createPipelineLayout)
    TWICE(vkCreateComputePipelines, createCompute)
    TWICE(vkCreateGraphicsPipelines, createGraphics)
    TWICE(vkDestroyShaderModule, destroyModule)
    TWICE(vkDestroyDescriptorSetLayout, destroySetLayout)
    TWICE(vkDestroyPipelineLayout, destroyPipelineLayout)
#undef TWICE
    return vkGetDeviceProcAddr(device, name);
}

} // namespace

void compileTwice(const NullDevice* device) {
    twins() = {device, {}, {}, {}};
}

std::vector<CompiledPipeline>& compiledPipelines() {
    static std::vector<CompiledPipeline> all;
    return all;
}

PFN_vkVoidFunction VKAPI_CALL compiledTwiceGetInstanceProcAddr(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getDeviceProcAddr);
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(&twinsProperties);
    return vkGetInstanceProcAddr(instance, name);
}

} // namespace tests
