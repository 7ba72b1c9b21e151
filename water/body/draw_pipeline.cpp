#include "water/body/draw_pipeline.h"

#include <vector>

#include "gpu/pipeline/compile_watch.h"
#include "gpu/pipeline/kernel.h"
#include "shaders/shared/one_view_block.h"
#include "water/body/part.h"

namespace seaglass {

namespace {

struct PipelineState {
    PipelineState(const TargetDesc& desc, Drawing drawing) {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        rasterization.polygonMode = VK_POLYGON_MODE_FILL;
        rasterization.cullMode = VK_CULL_MODE_NONE;
        rasterization.lineWidth = 1;
        multisample.rasterizationSamples = desc.samples;
        depth.depthTestEnable = drawing == Drawing::solid || drawing == Drawing::floating;
        depth.depthWriteEnable = drawing == Drawing::solid && desc.depthWrite;
        depth.depthCompareOp =
            desc.reversedDepth ? VK_COMPARE_OP_GREATER_OR_EQUAL : VK_COMPARE_OP_LESS_OR_EQUAL;
        attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                    VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        if (drawing == Drawing::blended || drawing == Drawing::floating || drawing == Drawing::scaled) {
            const bool scaled = drawing == Drawing::scaled;
            if (!scaled) attachment.colorWriteMask &= ~VkColorComponentFlags(VK_COLOR_COMPONENT_A_BIT);
            attachment.blendEnable = VK_TRUE;
            const bool doubled =
                scaled && desc.encoding == Encoding::srgb; // shaders/water/below/caustics.frag
            attachment.srcColorBlendFactor = scaled ? VK_BLEND_FACTOR_DST_COLOR : VK_BLEND_FACTOR_SRC_ALPHA;
            attachment.dstColorBlendFactor = doubled  ? VK_BLEND_FACTOR_SRC_COLOR
                                             : scaled ? VK_BLEND_FACTOR_ZERO
                                                      : VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
            attachment.srcAlphaBlendFactor = doubled ? VK_BLEND_FACTOR_ONE : VK_BLEND_FACTOR_DST_ALPHA;
        }
        if (drawing == Drawing::added) {
            attachment.blendEnable = VK_TRUE;
            attachment.srcColorBlendFactor = attachment.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
            attachment.colorWriteMask &= ~VkColorComponentFlags(VK_COLOR_COMPONENT_A_BIT);
        }
        blend.attachmentCount = 1;
        blend.pAttachments = &attachment;
        dynamic.dynamicStateCount = 2;
        dynamic.pDynamicStates = dynamicStates;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachmentFormats = &colorFormat;
        colorFormat = desc.colorFormat;
        rendering.depthAttachmentFormat = desc.depthFormat;
        rendering.stencilAttachmentFormat = desc.stencilFormat;
        rendering.viewMask = desc.viewMask;
    }
    PipelineState(const PipelineState&) = delete;
    PipelineState& operator=(const PipelineState&) = delete;

    const VkDynamicState dynamicStates[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkFormat colorFormat = VK_FORMAT_UNDEFINED;
    VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    VkPipelineRasterizationStateCreateInfo rasterization{
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    VkPipelineMultisampleStateCreateInfo multisample{
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    VkPipelineColorBlendAttachmentState attachment{};
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
};

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, const gpu::ShaderModule& module) {
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = which;
    info.module = module.handle();
    info.pName = "main";
    return info;
}

} // namespace

void bindDraw(const gpu::Device& device, VkCommandBuffer commands, const DrawPipeline& pipeline,
              VkDescriptorSet set, uint32_t viewIndex) {
    const gpu::DeviceTable& vk = device.vk();
    const VkPipelineLayout layout = pipeline.layout.pipeline();
    vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
    vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0, nullptr);
    const OneViewBlock pushed{viewIndex};
    if (const VkShaderStageFlags stages = pipeline.layout.pushedTo())
        vk.CmdPushConstants(commands, layout, stages, 0, sizeof pushed, &pushed);
}

void setViewport(const gpu::Device& device, VkCommandBuffer commands, const ViewDesc& view,
                 const ViewGeometry& geometry) {
    device.vk().CmdSetViewport(commands, 0, 1, &view.viewport);
    const VkRect2D scissor = {
        {geometry.regionOrigin.x, geometry.regionOrigin.y},
        {static_cast<uint32_t>(geometry.regionSize.x), static_cast<uint32_t>(geometry.regionSize.y)}};
    device.vk().CmdSetScissor(commands, 0, 1, &scissor);
}

Status recordTriangles(Context& context, const DrawCall& call, const BodyView& view,
                       const DrawPipeline& pipeline, const char* pass, uint32_t triangles,
                       std::span<const gpu::Bound> resources) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline.layout, resources, set); s != Status::ok)
        return s;
    setViewport(context.device, call.commands, *view.given, view.geometry);
    const gpu::PassScope scope(context.device, call.commands, pass);
    bindDraw(context.device, call.commands, pipeline, set, view.given->viewIndex);
    context.device.vk().CmdDraw(call.commands, 3 * triangles, 1, 0, 0);
    return Status::ok;
}

Status createDrawPipeline(const gpu::Device& device, const TargetDesc& target, const DrawShaders& shaders,
                          Drawing drawing, const char* what, DrawPipeline& out) {
    gpu::ShaderModule vertex(device);
    gpu::ShaderModule fragment(device);
    if (const Status s = vertex.create(shaders.vertex, shaders.constants, what); s != Status::ok) return s;
    if (const Status s = fragment.create(shaders.fragment, shaders.constants, what); s != Status::ok)
        return s;
    const std::span<const uint32_t> modules[] = {vertex.words(), fragment.words()};
    if (const Status s = out.layout.create(device, modules, sizeof(OneViewBlock), what); s != Status::ok)
        return s;

    std::vector<VkSpecializationMapEntry> entries(shaders.constants.size());
    for (uint32_t i = 0; i < shaders.constants.size(); ++i)
        entries[i] = {i, static_cast<uint32_t>(i * sizeof(uint32_t)), sizeof(uint32_t)};
    const VkSpecializationInfo specialization{static_cast<uint32_t>(shaders.constants.size()), entries.data(),
                                              shaders.constants.size_bytes(), shaders.constants.data()};
    VkPipelineShaderStageCreateInfo stages[] = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                                                stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    for (VkPipelineShaderStageCreateInfo& each : stages) each.pSpecializationInfo = &specialization;

    const PipelineState state(target, drawing);
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.pNext = target.renderPass ? nullptr : &state.rendering;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &state.input;
    info.pInputAssemblyState = &state.assembly;
    info.pViewportState = &state.viewport;
    info.pRasterizationState = &state.rasterization;
    info.pMultisampleState = &state.multisample;
    info.pDepthStencilState = &state.depth;
    info.pColorBlendState = &state.blend;
    info.pDynamicState = &state.dynamic;
    info.layout = out.layout.pipeline();
    info.renderPass = target.renderPass;
    info.subpass = target.subpass;
    const gpu::CompileWatch watch(device, what);
    return device.made(device.vk().CreateGraphicsPipelines(device.handle(), device.pipelineCache(), 1, &info,
                                                           device.allocator(), &out.handle),
                       VK_OBJECT_TYPE_PIPELINE, out.handle, what);
}

} // namespace seaglass
