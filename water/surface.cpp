#include "water/surface.h"

#include <array>
#include <span>
#include <vector>

#include "gpu/kernel.h"
#include "spirv/surface.frag.h"
#include "spirv/surface.vert.h"
#include "spirv/surface_l.frag.h"
#include "spirv/surface_lr.frag.h"
#include "spirv/surface_r.frag.h"
#include "spirv/surface_w.frag.h"
#include "spirv/surface_waves.vert.h"
#include "spirv/surface_wf.frag.h"
#include "spirv/surface_wfl.frag.h"
#include "spirv/surface_wflr.frag.h"
#include "spirv/surface_wfr.frag.h"
#include "spirv/surface_wl.frag.h"
#include "spirv/surface_wlr.frag.h"
#include "spirv/surface_wr.frag.h"
#include "water/mesh.h"

namespace seaglass {

namespace {

std::span<const uint32_t> vertexShader(const SurfaceFeatures& f) {
    if (f.waves) return surface_waves_vert;
    return surface_vert;
}

// Letters in the names: w waves, f foam, l reflection, r refraction.
std::span<const uint32_t> fragmentShader(const SurfaceFeatures& f) {
    const int base = (f.reflection ? 1 : 0) + (f.refraction ? 2 : 0);
    const std::span<const uint32_t> calm[] = {surface_frag, surface_l_frag, surface_r_frag, surface_lr_frag};
    const std::span<const uint32_t> waves[] = {surface_w_frag, surface_wl_frag, surface_wr_frag,
                                               surface_wlr_frag};
    const std::span<const uint32_t> foam[] = {surface_wf_frag, surface_wfl_frag, surface_wfr_frag,
                                              surface_wflr_frag};
    if (!f.waves) return calm[base];
    return f.foam ? foam[base] : waves[base];
}

/// In the order of shaders/common/surface.glsl, which numbers bindings likewise.
template<typename Item, typename Waves, typename Foam, typename Reflection, typename Refraction>
std::vector<Item> byFeature(const SurfaceFeatures& f, std::initializer_list<Item> always, Waves&& waves,
                            Foam&& foam, Reflection&& reflection, Refraction&& refraction) {
    std::vector<Item> list(always);
    if (f.waves)
        for (const Item& item : waves()) list.push_back(item);
    if (f.foam)
        for (const Item& item : foam()) list.push_back(item);
    if (f.reflection)
        for (const Item& item : reflection()) list.push_back(item);
    if (f.refraction)
        for (const Item& item : refraction()) list.push_back(item);
    return list;
}

std::vector<VkDescriptorType> bindings(const SurfaceFeatures& f) {
    constexpr VkDescriptorType image = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    return byFeature<VkDescriptorType>(
        f, {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, image},
        [] {
            return std::array{image, image, image};
        },
        [] {
            return std::array{image, image};
        },
        [] {
            return std::array{image, image};
        },
        [] {
            return std::array{image, image};
        });
}

std::vector<gpu::Resource> resources(const Context& context, const SurfaceFeatures& f,
                                     const SurfaceInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    const LightingDesc& light = *in.lighting;
    return byFeature<gpu::Resource>(
        f,
        {gpu::uniformBuffer(in.uniforms.buffer, in.uniforms.offset, sizeof(SurfaceUniforms)),
         gpu::storageBuffer(in.patches.buffer, in.patches.offset, sizeof(MeshPatch) * in.patchCount),
         gpu::sampledImage(samplers.trilinearClamp(), light.skyCube, light.skyCubeLayout)},
        [&] {
            const VkSampler s = samplers.trilinearRepeat();
            return std::array{gpu::sampledImage(s, in.waveMaps[0]), gpu::sampledImage(s, in.waveMaps[1]),
                              gpu::sampledImage(s, in.waveMaps[2])};
        },
        [&] {
            const VkSampler s = samplers.trilinearRepeat();
            return std::array{gpu::sampledImage(s, in.foamPattern), gpu::sampledImage(s, in.foamHistory)};
        },
        [&] {
            return std::array{gpu::sampledImage(samplers.trilinearClamp(), in.reflection.color),
                              gpu::sampledImage(samplers.nearestClamp(), in.reflection.info)};
        },
        [&] {
            return std::array{gpu::sampledImage(samplers.nearestClamp(), in.view->sceneColor.view,
                                                in.view->sceneColor.layout),
                              gpu::sampledImage(samplers.nearestClamp(), in.view->sceneDepth.view,
                                                in.view->sceneDepth.layout)};
        });
}

/// The fixed state of a surface: indexed triangles seen from both sides, depth tested and written, no
/// blending.
struct PipelineState {
    explicit PipelineState(const TargetDesc& desc) {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        rasterization.polygonMode = VK_POLYGON_MODE_FILL;
        rasterization.cullMode = VK_CULL_MODE_NONE;
        rasterization.lineWidth = 1;
        multisample.rasterizationSamples = desc.samples;
        depth.depthTestEnable = VK_TRUE;
        depth.depthWriteEnable = VK_TRUE;
        depth.depthCompareOp =
            desc.reversedDepth ? VK_COMPARE_OP_GREATER_OR_EQUAL : VK_COMPARE_OP_LESS_OR_EQUAL;
        attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                    VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        blend.attachmentCount = 1;
        blend.pAttachments = &attachment;
        dynamic.dynamicStateCount = 2;
        dynamic.pDynamicStates = dynamicStates;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachmentFormats = &colorFormat;
        colorFormat = desc.colorFormat;
        rendering.depthAttachmentFormat = desc.depthFormat;
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

SurfacePipelines::~SurfacePipelines() {
    for (auto& [key, pipeline] : pipelines_)
        device_->vk().DestroyPipeline(device_->handle(), pipeline.handle, device_->allocator());
}

void SurfacePipelines::init(const gpu::Device& device, const TargetDesc& desc) {
    device_ = &device;
    desc_ = desc;
}

Status SurfacePipelines::get(SurfaceFeatures features, SurfaceOutput output, const Pipeline*& out) {
    const auto [entry, fresh] = pipelines_.try_emplace({features, output});
    if (fresh)
        if (const Status s = build(features, output, entry->second); s != Status::ok) {
            pipelines_.erase(entry);
            return s;
        }
    out = &entry->second;
    return Status::ok;
}

Status SurfacePipelines::build(SurfaceFeatures features, SurfaceOutput output, Pipeline& out) const {
    constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    const std::vector<VkDescriptorType> types = bindings(features);
    if (const Status s = out.layout.create(*device_, types, stages, 0, "surface layout"); s != Status::ok)
        return s;
    gpu::ShaderModule vertex(*device_);
    gpu::ShaderModule fragment(*device_);
    if (const Status s = vertex.create(vertexShader(features), "surface vertex shader"); s != Status::ok)
        return s;
    if (const Status s = fragment.create(fragmentShader(features), "surface fragment shader");
        s != Status::ok)
        return s;

    const auto outputValue = static_cast<uint32_t>(output);
    const VkSpecializationMapEntry entry{0, 0, sizeof outputValue};
    const VkSpecializationInfo specialization{1, &entry, sizeof outputValue, &outputValue};
    VkPipelineShaderStageCreateInfo stageInfos[] = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                                                    stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    stageInfos[1].pSpecializationInfo = &specialization;

    const PipelineState state(desc_);
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.pNext = desc_.renderPass ? nullptr : &state.rendering;
    info.stageCount = 2;
    info.pStages = stageInfos;
    info.pVertexInputState = &state.input;
    info.pInputAssemblyState = &state.assembly;
    info.pViewportState = &state.viewport;
    info.pRasterizationState = &state.rasterization;
    info.pMultisampleState = &state.multisample;
    info.pDepthStencilState = &state.depth;
    info.pColorBlendState = &state.blend;
    info.pDynamicState = &state.dynamic;
    info.layout = out.layout.pipeline();
    info.renderPass = desc_.renderPass;
    info.subpass = desc_.subpass;
    return device_->check(device_->vk().CreateGraphicsPipelines(device_->handle(), device_->pipelineCache(),
                                                                1, &info, device_->allocator(), &out.handle),
                          "surface pipeline");
}

Status recordSurface(Context& context, VkCommandBuffer commands, const SurfacePipelines::Pipeline& pipeline,
                     SurfaceFeatures features, const SurfaceInputs& inputs) {
    const std::vector<gpu::Resource> list = resources(context, features, inputs);
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline.layout.set(), list, set); s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, "surface");
    const gpu::DeviceTable& vk = context.device.vk();
    vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
    vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.layout.pipeline(), 0, 1,
                             &set, 0, nullptr);
    vk.CmdBindIndexBuffer(commands, inputs.indices, 0, VK_INDEX_TYPE_UINT16);
    vk.CmdDrawIndexed(commands, patchCells * patchCells * 6, inputs.patchCount, 0, 0, 0);
    return Status::ok;
}

} // namespace seaglass
