// What a compiler says that a pipeline's stages take, by VK_KHR_pipeline_executable_properties under the
// names of Mesa's driver for AMD.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/null/null_device.h"

namespace tests {

struct StageCosts {
    VkShaderStageFlags stages = 0;
    uint64_t instructions = 0;
    uint64_t vectorRegisters = 0, scalarRegisters = 0;
    uint64_t spilledVectors = 0; ///< vector registers that are written to memory and read again
    uint64_t spilledScalars = 0; ///< scalar registers, likewise to lanes of a vector register
    uint64_t waves = 0;       ///< that a SIMD unit holds at once, by registers and shared memory; 32 at most
    uint64_t sharedBytes = 0; ///< of a workgroup
};

/// Of a pipeline with VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR. Empty where the driver leaves any of
/// these out.
std::vector<StageCosts> costsOf(const NullDevice& device, VkPipeline pipeline);

} // namespace tests
