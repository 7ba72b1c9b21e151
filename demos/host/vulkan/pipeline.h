// Pipelines of the host: those that draw are for dynamic rendering.
#pragma once

#include <span>

#include "host/vulkan/device.h"

namespace demos {

struct PipelineDesc {
    std::span<const uint32_t> vertex;
    std::span<const uint32_t> fragment; ///< empty: depth alone
    bool meshVertices = true;           ///< fed with MeshVertex, or by vertex index alone
    bool otherUvs = false;              ///< and with OtherUvs at binding 1, or each as MeshVertex::uv
    const VkPipelineVertexInputStateCreateInfo* vertices = nullptr; ///< other ones, without meshVertices
    bool blends = false; ///< over what is there, by the fragment's alpha
    VkFormat colorFormat = VK_FORMAT_UNDEFINED;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL;
    bool depthWrite = true;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkSampleMask sampleMask = ~0u;       ///< those that are written
    std::span<const uint32_t> constants; ///< the fragment shader's, from 0 on
    float slopeBias = 0;
};

/// Viewport, scissor, cull mode and front face are dynamic.
bool createPipeline(const Device& device, VkPipelineLayout layout, const PipelineDesc& desc,
                    UniquePipeline& out, Error& error);

/// `constants` specialise it; null: none.
bool createComputePipeline(const Device& device, std::span<const uint32_t> spirv, VkPipelineLayout layout,
                           const VkSpecializationInfo* constants, UniquePipeline& out, Error& error);

} // namespace demos
