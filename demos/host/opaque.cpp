#include "host/opaque.h"

#include "host/pipeline.h"
#include "host/rendering.h"
#include "spirv/opaque.frag.h"
#include "spirv/opaque.vert.h"

namespace demos {

bool OpaquePass::create(const Device& device, const Layouts& layouts, Error& error) {
    PipelineDesc desc;
    desc.vertex = opaque_vert;
    desc.fragment = opaque_frag;
    desc.colorFormat = FrameTargets::colorFormat;
    desc.depthFormat = FrameTargets::depthFormat;
    PipelineDesc masked = desc;
    const uint32_t isMasked[] = {VK_TRUE};
    masked.constants = isMasked;
    return createPipeline(device, layouts.pipeline.get(), desc, opaque_, error) &&
           createPipeline(device, layouts.pipeline.get(), masked, masked_, error) &&
           sky_.create(device, layouts, desc.colorFormat, desc.depthFormat, error);
}

void OpaquePass::record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                        const Camera& camera, const FrameTargets& targets) const {
    targets.toAttachments(commands, VK_IMAGE_LAYOUT_UNDEFINED);
    beginRendering(commands, targets.extent, &targets.color, VK_ATTACHMENT_LOAD_OP_CLEAR, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, 0);
    drawMeshes(commands, layouts, meshes, camera.eye, meshPipelines(camera.projection * camera.rotation));
    sky_.draw(commands);
    vkCmdEndRendering(commands);
}

} // namespace demos
