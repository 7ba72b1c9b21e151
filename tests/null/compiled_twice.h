// Stands between the library and Vulkan: what the library makes of pipelines on its own device is made on a
// null device as well, and what they take there is kept.
#pragma once

#include <string>
#include <vector>

#include "tests/null/pipeline_costs.h"

namespace tests {

struct CompiledStage {
    std::string shader;              ///< by its file, such as "foam.comp"
    std::vector<uint32_t> constants; ///< words from number 0 on
    size_t spirvBytes = 0;
    StageCosts costs;
};

struct CompiledPipeline {
    VkResult result = VK_ERROR_UNKNOWN; ///< of the null device's driver
    std::vector<CompiledStage> stages;  ///< in the order of their VkShaderStageFlagBits

    const CompiledStage& last() const { return stages.back(); } ///< the one of compute or of fragments
};

/// From here on; null: nothing is made twice. Outlives what the library makes meanwhile.
void compileTwice(const NullDevice* device);

/// Those since it was last emptied. One list for the program.
std::vector<CompiledPipeline>& compiledPipelines();

/// To be handed to a context as its loader. The context takes its device for the null device's kind.
PFN_vkVoidFunction VKAPI_CALL compiledTwiceGetInstanceProcAddr(VkInstance instance, const char* name);

} // namespace tests
