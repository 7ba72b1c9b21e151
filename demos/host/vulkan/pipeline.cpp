#include "host/vulkan/pipeline.h"

#include <cstddef>
#include <iterator>

#include "host/files/mesh_file.h"

namespace demos {
namespace {

bool createModule(const Device& device, std::span<const uint32_t> code, UniqueShaderModule& out,
                  Error& error) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    if (!succeeded(vkCreateShaderModule(device.handle(), &info, nullptr, &shader), "vkCreateShaderModule",
                   error))
        return false;
    out = UniqueShaderModule(device.handle(), shader);
    return true;
}

constexpr VkVertexInputBindingDescription meshBindings[] = {
    {0, sizeof(MeshVertex), VK_VERTEX_INPUT_RATE_VERTEX},
    {1, sizeof(OtherUvs), VK_VERTEX_INPUT_RATE_VERTEX},
};

std::vector<VkVertexInputAttributeDescription> meshAttributes(bool otherUvs) {
    std::vector<VkVertexInputAttributeDescription> attributes = {
        {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(MeshVertex, position)},
        {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(MeshVertex, normal)},
        {2, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(MeshVertex, uv)},
        {3, 0, VK_FORMAT_R16G16B16A16_UNORM, offsetof(MeshVertex, color)},
    };
    for (uint32_t i = 0; i < std::tuple_size_v<OtherUvs>; ++i)
        attributes.push_back({4 + i, otherUvs ? 1u : 0u, VK_FORMAT_R32G32_SFLOAT,
                              otherUvs ? i * static_cast<uint32_t>(sizeof(glm::vec2))
                                       : static_cast<uint32_t>(offsetof(MeshVertex, uv))});
    return attributes;
}

/// The shaders, and what the fragment shader is specialised by. It points into itself.
struct Stages {
    Stages() = default;
    Stages(const Stages&) = delete;
    Stages& operator=(const Stages&) = delete;

    bool create(const Device& device, const PipelineDesc& desc, Error& error) {
        if (!createModule(device, desc.vertex, vertex, error)) return false;
        if (!desc.fragment.empty() && !createModule(device, desc.fragment, fragment, error)) return false;
        for (uint32_t i = 0; i < desc.constants.size(); ++i)
            entries.push_back({i, i * static_cast<uint32_t>(sizeof(uint32_t)), sizeof(uint32_t)});
        constants = {static_cast<uint32_t>(entries.size()), entries.data(), desc.constants.size_bytes(),
                     desc.constants.data()};
        infos[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
        infos[0].module = vertex.get();
        infos[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
        infos[1].module = fragment.get();
        infos[1].pSpecializationInfo = &constants;
        infos[0].pName = infos[1].pName = "main";
        return true;
    }

    UniqueShaderModule vertex, fragment;
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo constants{};
    VkPipelineShaderStageCreateInfo infos[2] = {{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO},
                                                {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}};
};

/// Likewise.
struct VertexInput {
    explicit VertexInput(const PipelineDesc& desc) : attributes(meshAttributes(desc.otherUvs)) {
        if (desc.vertices) info = *desc.vertices;
        if (!desc.meshVertices) return;
        info.vertexBindingDescriptionCount = desc.otherUvs ? 2 : 1;
        info.pVertexBindingDescriptions = meshBindings;
        info.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size());
        info.pVertexAttributeDescriptions = attributes.data();
    }
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    std::vector<VkVertexInputAttributeDescription> attributes;
    VkPipelineVertexInputStateCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
};

constexpr VkDynamicState dynamics[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};

/// What is no shader. It points into itself and its description.
struct FixedFunctions {
    explicit FixedFunctions(const PipelineDesc& desc) {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        raster.lineWidth = 1;
        raster.depthBiasEnable = desc.slopeBias != 0;
        raster.depthBiasSlopeFactor = desc.slopeBias;
        multisample.rasterizationSamples = desc.samples;
        multisample.pSampleMask = &desc.sampleMask;
        depth.depthTestEnable = VK_TRUE;
        depth.depthWriteEnable = desc.depthWrite;
        depth.depthCompareOp = desc.depthCompare;
        attachment.colorWriteMask = 0xf;
        attachment.blendEnable = desc.blends;
        attachment.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
        attachment.dstColorBlendFactor = attachment.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        attachment.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
        blend.attachmentCount = desc.colorFormat == VK_FORMAT_UNDEFINED ? 0 : 1;
        blend.pAttachments = &attachment;
        dynamic.dynamicStateCount = static_cast<uint32_t>(std::size(dynamics));
        dynamic.pDynamicStates = dynamics;
    }
    FixedFunctions(const FixedFunctions&) = delete;
    FixedFunctions& operator=(const FixedFunctions&) = delete;

    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    VkPipelineMultisampleStateCreateInfo multisample{
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    VkPipelineColorBlendAttachmentState attachment{};
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
};

} // namespace

bool createPipeline(const Device& device, VkPipelineLayout layout, const PipelineDesc& desc,
                    UniquePipeline& out, Error& error) {
    Stages stages;
    if (!stages.create(device, desc, error)) return false;
    const VertexInput input(desc);
    const FixedFunctions fixed(desc);
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = fixed.blend.attachmentCount;
    rendering.pColorAttachmentFormats = &desc.colorFormat;
    rendering.depthAttachmentFormat = desc.depthFormat;

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
    info.stageCount = desc.fragment.empty() ? 1 : 2;
    info.pStages = stages.infos;
    info.pVertexInputState = &input.info;
    info.pInputAssemblyState = &fixed.assembly;
    info.pViewportState = &fixed.viewport;
    info.pRasterizationState = &fixed.raster;
    info.pMultisampleState = &fixed.multisample;
    info.pDepthStencilState = &fixed.depth;
    info.pColorBlendState = &fixed.blend;
    info.pDynamicState = &fixed.dynamic;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    if (!succeeded(vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                   "vkCreateGraphicsPipelines", error))
        return false;
    out = UniquePipeline(device.handle(), pipeline);
    return true;
}

bool createComputePipeline(const Device& device, std::span<const uint32_t> spirv, VkPipelineLayout layout,
                           const VkSpecializationInfo* constants, UniquePipeline& out, Error& error) {
    UniqueShaderModule shader;
    if (!createModule(device, spirv, shader, error)) return false;
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader.get();
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = constants;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    if (!succeeded(vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                   "vkCreateComputePipelines", error))
        return false;
    out = UniquePipeline(device.handle(), pipeline);
    return true;
}

} // namespace demos
