#include "host/passes/full_screen_pass.h"

#include "host/vulkan/rendering.h"

#include "spirv/full_screen.frag.h"
#include "spirv/full_screen.vert.h"

namespace demos {

bool FullScreenPass::create(const Device& device, Error& error) {
    PipelineDesc desc;
    desc.vertex = full_screen_vert;
    desc.fragment = full_screen_frag;
    desc.meshVertices = false;
    desc.colorFormat = FrameTargets::colorFormat;
    desc.depthWrite = false;
    return drawing_.create(device, desc, 0, error);
}

void FullScreenPass::record(const Device& device, VkCommandBuffer commands,
                            const FrameTargets& targets) const {
    drawing_.point(device, targets.sceneColor.view.get());
    targets.betweenPasses(commands);
    beginRendering(commands, targets.extent, targets.color.view.get(), VK_ATTACHMENT_LOAD_OP_LOAD,
                   VK_NULL_HANDLE, VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    drawing_.bind(commands);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

} // namespace demos
