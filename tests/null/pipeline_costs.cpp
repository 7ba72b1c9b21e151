#include "tests/null/pipeline_costs.h"

#include <algorithm>
#include <string_view>

namespace tests {

namespace {

using Statistics = std::vector<VkPipelineExecutableStatisticKHR>;

Statistics statisticsOf(const NullDevice& device, VkPipeline pipeline, uint32_t executable) {
    VkPipelineExecutableInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR};
    info.pipeline = pipeline;
    info.executableIndex = executable;
    uint32_t count = 0;
    device.vk().vkGetPipelineExecutableStatisticsKHR(device.handle(), &info, &count, nullptr);
    Statistics all(count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
    device.vk().vkGetPipelineExecutableStatisticsKHR(device.handle(), &info, &count, all.data());
    return all;
}

/// Adds the one of that name to `sum`; false where there is none.
bool add(const Statistics& all, std::string_view name, uint64_t& sum) {
    const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.name == name; });
    if (found == all.end()) return false;
    sum += found->value.u64;
    return true;
}

} // namespace

std::vector<StageCosts> costsOf(const NullDevice& device, VkPipeline pipeline) {
    VkPipelineInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR};
    info.pipeline = pipeline;
    uint32_t count = 0;
    device.vk().vkGetPipelineExecutablePropertiesKHR(device.handle(), &info, &count, nullptr);
    std::vector<VkPipelineExecutablePropertiesKHR> executables(
        count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
    device.vk().vkGetPipelineExecutablePropertiesKHR(device.handle(), &info, &count, executables.data());

    std::vector<StageCosts> costs(count);
    for (uint32_t i = 0; i < count; ++i) {
        StageCosts& c = costs[i];
        c.stages = executables[i].stages;
        const Statistics all = statisticsOf(device, pipeline, i);
        const bool told = add(all, "Instructions", c.instructions) && add(all, "VGPRs", c.vectorRegisters) &&
                          add(all, "SGPRs", c.scalarRegisters) &&
                          add(all, "Spilled VGPRs", c.spilledVectors) &&
                          add(all, "Spilled SGPRs", c.spilledScalars) &&
                          add(all, "Subgroups per SIMD", c.waves) && add(all, "LDS size", c.sharedBytes);
        if (!told) return {};
    }
    return costs;
}

} // namespace tests
