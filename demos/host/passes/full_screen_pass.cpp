#include "host/passes/full_screen_pass.h"

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"
#include "host/vulkan/rendering.h"

#include "spirv/full_screen.frag.h"
#include "spirv/full_screen.vert.h"

namespace demos {

bool FullScreenPass::create(const Device& device, Error& error) {
    constexpr VkDescriptorType texture[] = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    const VkDescriptorPoolSize size = {texture[0], 1};
    PipelineDesc desc;
    desc.vertex = full_screen_vert;
    desc.fragment = full_screen_frag;
    desc.meshVertices = false;
    desc.colorFormat = FrameTargets::colorFormat;
    desc.depthWrite = false;
    return createSampler(device, {}, sampler_, error) &&
           createSetLayout(device, texture, setLayout_, error) &&
           allocateSet(device, setLayout_.get(), {&size, 1}, pool_, set_, error) &&
           createPipelineLayout(device, {&setLayout_.get(), 1}, 0, layout_, error) &&
           createPipeline(device, layout_.get(), desc, pipeline_, error);
}

void FullScreenPass::record(const Device& device, VkCommandBuffer commands,
                            const FrameTargets& targets) const {
    writeTexture(device, set_, 0, targets.sceneColor.view.get(), sampler_.get());
    targets.betweenPasses(commands);
    beginRendering(commands, targets.extent, targets.color.view.get(), VK_ATTACHMENT_LOAD_OP_LOAD,
                   VK_NULL_HANDLE, VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_, 0,
                            nullptr);
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

} // namespace demos
